#include <gcm_gui/inspector/configuration_model.h>
#include <gcm_gui/models/row_roles.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>

namespace tendon::gui {
namespace {

QStringList RowsOf(const std::string& configuration) {
  ConfigurationModel model;
  const QAbstractItemModelTester tester(&model);
  ComponentDescription component;
  component.class_name = "Arm";
  component.configuration = configuration;
  model.show(component);
  QStringList rows;
  for (int row = 0; row < model.rowCount(); ++row) {
    rows << model.index(row).data(Qt::AccessibleTextRole).toString();
  }
  return rows;
}

TEST(ConfigurationModel, ListsParametersByTheirPath) {
  EXPECT_EQ(
      RowsOf(R"({"gains": {"p": 2.5, "list": [1, 2]}, "joints": [{"name": "elbow"}]})"),
      (QStringList{"class: Arm", "gains.p: 2.5", "gains.list: [1,2]", "joints[0].name: elbow"}));
}

TEST(ConfigurationModel, WithoutAConfigurationListsTheClassOnly) {
  EXPECT_EQ(RowsOf(""), QStringList{"class: Arm"});
}

TEST(ConfigurationModel, ShowsInvalidJsonVerbatim) {
  EXPECT_EQ(RowsOf("{ rate"), (QStringList{"class: Arm", "configuration: { rate"}));
}

}  // namespace
}  // namespace tendon::gui
