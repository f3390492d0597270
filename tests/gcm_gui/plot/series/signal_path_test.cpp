#include <gcm_gui/plot/series/signal_path.h>
#include <gmock/gmock.h>

#include <QMimeData>

namespace tendon::gui {
namespace {

TEST(SignalPath, HasASourceAShortNameAndAColumn) {
  const QString path = "robot/arm/state.Joints.position[0]";

  EXPECT_EQ(SourceOf(path), "robot/arm/state");
  EXPECT_EQ(ShortName(path), "arm.Joints.position[0]");
  EXPECT_EQ(ColumnOf(path), "Joints");
}

TEST(SignalPath, NamesATableOtherThanTheDefault) {
  EXPECT_EQ(ShortName("robot/arm/state-fast.Current"), "arm.fast.Current");
  EXPECT_EQ(ColumnOf("robot/arm/state.Load[3]"), "Load");
}

TEST(SignalPath, AnotherFormatIsShownUnchanged) {
  EXPECT_EQ(ShortName("temperature"), "temperature");
  EXPECT_EQ(SourceOf("temperature"), "temperature");
}

TEST(SignalPath, RoundTripsThroughDragData) {
  const QList<CurveKey> keys{{"robot/arm/state.Joints.position[0]", "rad"},
                             {"desk/host/state.Load", ""}};
  QMimeData data;

  data.setData(kPathMimeType, EncodedPaths(keys));

  EXPECT_EQ(PathsIn(data), keys);
}

TEST(SignalPath, IgnoresLinesWithoutAPath) {
  QMimeData data;
  data.setData(kPathMimeType, "\n\trad\na/b/c.d\n");

  EXPECT_EQ(PathsIn(data), (QList<CurveKey>{{"a/b/c.d", ""}}));
}

TEST(SignalPath, ARecordedSignalHasAFileAndASignal) {
  const QString signal = "robot/arm/state.Joints.position[0]";
  const QString path = RecordedPath("/home/ann//a.b/run 1.mcap", signal);

  EXPECT_EQ(RecordingOf(path), "/home/ann/a.b/run 1.mcap");
  EXPECT_EQ(RecordingName(path), "run 1.mcap");
  EXPECT_EQ(SignalOf(path), signal);
  EXPECT_EQ(ShortName(path), "arm.Joints.position[0]");
  EXPECT_EQ(ColumnOf(path), "Joints");
  EXPECT_EQ(FullName(path), QString("run 1.mcap · ") + signal);
  EXPECT_EQ(RecordingOf(signal), "");
  EXPECT_EQ(SignalOf(signal), signal);
  EXPECT_EQ(FullName(signal), signal);
}

TEST(SignalPath, ADragOfBrokenOriginIsOneOfTheShownSystem) {
  for (const char* origin : {"", "12", "12\n", "x\n/run.mcap", "\n/run.mcap"}) {
    QMimeData data;
    data.setData(kPathMimeType, "a/b/c.d\trad");
    data.setData(kRecordingMimeType, origin);

    EXPECT_EQ(PathsIn(data), (QList<CurveKey>{{"a/b/c.d", "rad"}})) << origin;
    EXPECT_EQ(RecordedMomentIn(data), std::nullopt) << origin;
  }
}

}  // namespace
}  // namespace tendon::gui
