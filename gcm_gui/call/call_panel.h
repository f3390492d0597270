#pragma once

#include <gcm_gui/session/command_calls.h>
#include <tendon/gcm/argument/matching_read.h>
#include <tendon/interface/description.h>

#include <QHash>
#include <QString>
#include <QTimer>
#include <QWidget>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

class QLabel;
class QPlainTextEdit;
class QScrollArea;
class QStackedWidget;
class QToolButton;

namespace tendon::gui {

class HeadRow;
class HoldButton;
class PictureView;
class RepeatRow;
class ValueForm;

/// Calls one command: a form for its argument, or JSON, and below it what came of the call. What
/// was last said to a command stands there again when it is shown the next time; before that, what
/// a matching read command says, or as many fields of it as are the same. Hidden while it has no
/// command.
class CallPanel : public QWidget {
  Q_OBJECT

 public:
  explicit CallPanel(CommandCalls& calls, QWidget* parent = nullptr);

  /// "robot/arm/Control.SetGains". The same command again changes nothing. `reads` may say
  /// what this would set, the likeliest first.
  void showCommand(const QString& path, const MemberDescription& command,
                   const std::vector<MatchingRead>& reads = {});
  void showNothing();
  /// Where its first value is entered, or what calls it.
  void focusFirst();
  /// Why it cannot be called now; empty where it can.
  void setUnavailable(const QString& reason);
  /// A call can set something in motion: the button is held for a while, the key pressed twice.
  void setCareful(bool careful);

 Q_SIGNALS:
  /// Somebody wants it at hand: a command and its argument, JSON.
  void favouriteRequested(const QString& path, const QString& argument);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void call();
  void callByKey();
  void build();
  [[nodiscard]] QWidget* buildArgument();
  [[nodiscard]] QWidget* buildButtons();
  void buildRepeat();
  void askForSchema();
  void hearSchema(const Result<Schema>& schema);
  void hearAnswer(const Result<std::string>& answer, double seconds);
  void showForm(const Schema& schema);
  // From that read command on: which fields it has, what it says of them, or of all.
  void askForOffer(std::size_t read);
  void hearOffer(std::size_t read, const Result<Schema>& offered);
  void askForValue(const std::string& read, const std::vector<std::string>& fields);
  void hearValue(const std::string& read, const std::vector<std::string>& fields,
                 const Result<std::string>& value);
  void fitForm();
  /// Not where what stands there is no JSON of the type: nothing of it would be lost.
  void showAsJson(bool as_json);
  /// What would be said now; empty for a command without an argument.
  [[nodiscard]] std::string argument() const;
  /// Says what is wrong with the argument, and keeps it from being called.
  void check();
  [[nodiscard]] QString problemOf(const Error& error) const;
  void tell(const QString& text, const QString& role);
  void copyCommand() const;

  CommandCalls& calls_;
  QString path_;
  MemberDescription command_;
  std::vector<MatchingRead> reads_;
  bool is_touched_ = false;       // its form, by a person
  std::optional<Schema> schema_;  // of the argument
  bool takes_argument_ = false;
  /// Of another command, or of an earlier time, what is answered late tells nothing.
  std::uint64_t shown_ = 0;
  bool under_way_ = false;
  QTimer second_key_;
  QString unavailable_;
  QHash<QString, std::string> last_arguments_;  // by path

  HeadRow* head_ = nullptr;
  QLabel* kind_ = nullptr;
  QLabel* expiry_ = nullptr;
  QStackedWidget* argument_ = nullptr;
  QScrollArea* form_area_ = nullptr;
  ValueForm* form_ = nullptr;
  QPlainTextEdit* json_ = nullptr;
  HoldButton* call_ = nullptr;
  RepeatRow* repeat_ = nullptr;
  QToolButton* as_json_ = nullptr;
  QToolButton* retry_ = nullptr;
  QLabel* status_ = nullptr;
  QLabel* answer_ = nullptr;
  PictureView* picture_ = nullptr;  // of an answer that is one
};

}  // namespace tendon::gui
