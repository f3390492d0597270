#include <gcm_gui/graph/graph_scene.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/graph/items/process_item.h>
#include <gcm_gui/views/catalogue_columns.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gmock/gmock.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QCoreApplication>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QTabBar>
#include <QTranslator>

#include "window/window_fixture.h"

namespace tendon::gui {
namespace {

/// A language that puts each text between marks. A text without marks was not translated.
class PseudoLanguage : public QTranslator {
 public:
  PseudoLanguage() { QCoreApplication::installTranslator(this); }
  ~PseudoLanguage() override { QCoreApplication::removeTranslator(this); }

  [[nodiscard]] bool isEmpty() const override { return false; }
  [[nodiscard]] QString translate(const char* /*context*/, const char* source,
                                  const char* /*comment*/, int /*n*/) const override {
    return QStringLiteral("«") + QString::fromUtf8(source) + QStringLiteral("»");
  }
};

/// A base class that installs the language before the members of the window are created.
struct Marked {
  PseudoLanguage language;
};

class PseudoLanguageTest : private Marked, public WindowFixture {
 protected:
  /// Collects the words of `text` that are neither translated nor names of the model. `text` is
  /// shown or spoken.
  void Read(const QObject& thing, const QString& text) {
    // The reason comes from the library, untranslated.
    if (thing.objectName().startsWith("lifecycle.")) return;
    QString rest = text;
    rest.replace(QRegularExpression("«[^«»]*(«[^«»]*»[^«»]*)*»"), QStringLiteral(" "));
    for (auto words = kWords.globalMatch(rest); words.hasNext();) {
      const QString word = words.next().captured();
      if (names_.contains(word.toLower())) continue;
      found_ << QStringLiteral("%1 \"%2\": %3").arg(thing.objectName(), text, word);
    }
  }
  void ReadAll(const QObject& below) {
    for (const auto* widget : below.findChildren<QWidget*>()) {
      Read(*widget, widget->toolTip());
      Read(*widget, widget->accessibleName());
      Read(*widget, widget->accessibleDescription());
    }
    for (const auto* one : below.findChildren<QLabel*>()) Read(*one, one->text());
    for (const auto* one : below.findChildren<QAbstractButton*>()) Read(*one, one->text());
    for (const auto* one : below.findChildren<QAction*>()) Read(*one, one->text());
    for (const auto* one : below.findChildren<QLineEdit*>()) Read(*one, one->placeholderText());
    for (const auto* one : below.findChildren<QTabBar*>()) {
      for (int tab = 0; tab < one->count(); ++tab) Read(*one, one->tabText(tab));
    }
    for (const auto* one : below.findChildren<QAbstractItemView*>()) ReadRows(*one, {});
  }
  void ReadRows(const QAbstractItemView& view, const QModelIndex& parent) {
    const QAbstractItemModel* model = view.model();
    if (model == nullptr) return;
    for (int column = 0; column < model->columnCount(parent) && !parent.isValid(); ++column) {
      Read(view, model->headerData(column, Qt::Horizontal).toString());
    }
    for (int row = 0; row < model->rowCount(parent); ++row) {
      for (int column = 0; column < model->columnCount(parent); ++column) {
        Read(view, model->index(row, column, parent).data().toString());
      }
      ReadRows(view, model->index(row, 0, parent));
    }
  }
  /// Adds words that are the same in every language: names, and words of filters and of the
  /// console.
  void AddNames() {
    for (const QString& part : QString(kSaidEverywhere).split(' ')) names_ << part.toLower();
    const auto add = [this](const std::string& text) {
      for (auto words = kWords.globalMatch(QString::fromStdString(text)); words.hasNext();) {
        names_ << words.next().captured().toLower();
      }
    };
    for (const auto& [name, entry] : store_.catalogue().processes()) {
      add(name);
      add(entry.process.host);
      add(entry.process.reason);
      for (const auto& [component, description] : entry.components) {
        add(component);
        add(description.class_name);
        add(description.library);
      }
    }
    const CatalogueModel& model = window_.catalogueModel();
    const std::function<void(const QModelIndex&)> below = [&](const QModelIndex& parent) {
      for (int row = 0; row < model.rowCount(parent); ++row) {
        const QModelIndex index = model.index(row, 0, parent);
        const CatalogueItem& item = *model.item(index);
        add(item.path.toStdString());
        add(item.detail.toStdString());
        add(KindWord(item.kind).toStdString());
        below(index);
      }
    };
    below({});
  }

  static constexpr auto kSaidEverywhere =
      "GCM JSON CSV gcm gui Ctrl Esc Enter Shift write read void qualified class Hz kHz min "
      "JetBrains Mono "
      "mono dim debug info warning error serve connect lcm demo json system file";
  const QRegularExpression kWords{QStringLiteral("[A-Za-z]{3,}")};
  QSet<QString> names_;
  QStringList found_;
};

TEST_F(PseudoLanguageTest, EveryTextIsTranslatable) {
  AddNames();
  for (int column = 1; column < CatalogueModel::kColumnCount; ++column) {
    window_.catalogue().tree().columns().setShown(column, true);
  }

  for (const char* path : {"robot/arm", "robot/arm/Control.MoveTo", "vision", "vision/camera",
                           "desk/teleoperation/Robot"}) {
    window_.selection().select(path);
    ReadAll(window_);
  }

  found_.removeDuplicates();
  EXPECT_TRUE(found_.isEmpty()) << found_.join('\n').toStdString();
}

TEST_F(PseudoLanguageTest, TheTitleOfALostProcessIsTranslated) {
  const ProcessItem& vision = *window_.graph().graph().processes().at("vision");

  EXPECT_THAT(vision.title().toStdString(), testing::StartsWith("vision · «lost»"));
}

}  // namespace
}  // namespace tendon::gui
