#pragma once

#include <gcm_gui/session/system_requests.h>
#include <tendon/gcm/initial_arguments.h>
#include <tendon/interface/interface_description.h>

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

class HeaderRow;
class HoldButton;
class ImageView;
class RepeatRow;
class ValueForm;

/// Calls one command: shows a form or JSON for the argument, and the result of the call below the
/// argument. At first, the form shows the last argument of this command. Before the first call, the
/// form shows the values that a matching read command returns for the same fields. The panel is
/// hidden while no command is shown.
class CallPanel : public QWidget {
  Q_OBJECT

 public:
  explicit CallPanel(CommandCalls& calls, QWidget* parent = nullptr);

  /// Shows a command, such as "robot/arm/Control.SetGains"; does nothing if this command is shown
  /// already. `reads` are the read commands that may return the present setting, best match first.
  void showCommand(const QString& path, const MemberDescription& command,
                   const std::vector<MatchingRead>& reads = {});
  void showNothing();
  /// Sets the focus to the first field, or to the call button if there is none.
  void focusFirst();
  /// Sets the reason why the command cannot be called now. An empty reason means that it can be
  /// called.
  void setUnavailable(const QString& reason);
  /// True for a command that can start a motion: the user must then hold the button or press the
  /// key twice.
  void setCareful(bool careful);

 Q_SIGNALS:
  /// The user wants to keep a command with its argument (JSON) as a favourite.
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
  void onSchema(const Result<Schema>& schema);
  void onResult(const Result<std::string>& result, double seconds);
  void showForm(const Schema& schema);
  // Tries the read commands from index `read` on: first requests their types, then their values.
  void askForOffer(std::size_t read);
  void onOffer(std::size_t read, const Result<Schema>& offered);
  void askForValue(const std::string& read, const std::vector<std::string>& fields);
  void onValue(const std::string& read, const std::vector<std::string>& fields,
               const Result<std::string>& value);
  void fitForm();
  /// Switches between form and JSON. Does nothing if the present text is not valid JSON of the
  /// argument's type, so that no input is lost.
  void showAsJson(bool as_json);
  /// Returns the present argument; empty for a command without an argument.
  [[nodiscard]] std::string argument() const;
  /// Checks the argument. If it is invalid, shows the mistake and disables the call.
  void check();
  [[nodiscard]] QString problemOf(const Error& error) const;
  void showStatus(const QString& text, const QString& role);
  void copyCommand() const;

  CommandCalls& calls_;
  QString path_;
  MemberDescription command_;
  std::vector<MatchingRead> reads_;
  bool is_touched_ = false;       // the user has edited the form
  std::optional<Schema> schema_;  // of the argument
  bool takes_argument_ = false;
  /// Incremented whenever another command is shown. Replies for an earlier command are ignored.
  std::uint64_t shown_ = 0;
  bool under_way_ = false;
  QTimer second_key_;
  QString unavailable_;
  QHash<QString, std::string> last_arguments_;  // by path

  HeaderRow* head_ = nullptr;
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
  QLabel* result_ = nullptr;
  ImageView* picture_ = nullptr;  // shows a result that is a picture
};

}  // namespace tendon::gui
