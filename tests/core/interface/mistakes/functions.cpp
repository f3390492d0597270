#include <tendon/interface/provided_interface.h>
#include <tendon/interface/required_interface.h>

// Each statement below is one mistake, and the compiler prints the sentence above it, and no other.

struct Goal {
  double position = 0;
};
template <>
inline constexpr auto tendon::kPayload<Goal> =
    tendon::Describe("test.Goal", tendon::Field{"position", &Goal::position});

struct Other {
  void Stop();
};

struct Arm {
  void Stop();
  void MoveTo(const Goal& goal);
  void Move(double speed, double time);
  void Take(Goal&& goal);
  Goal Get() const;
  void Read(Goal& goal);
  double Ask(const Goal& goal);
  static void Beep();
  static double Scaled(const double& row, int factor);

  int speed = 0;
  Goal row;
};

using tendon::kThreadSafe;

void NoFunctions(tendon::ProvidedInterface& provided, Arm* arm, const Arm* fixed, Other* other) {
  // error: given a value that is not a function; expected
  provided.AddCommandVoid(arm->speed, "A");
  // error: whose call operator is generic or overloaded
  provided.AddCommandWrite([](const auto& /*goal*/) {}, "B");
  // error: given a method without its object
  provided.AddCommandVoid(&Arm::Stop, "C");
  // error: given an object with a function that is not a method
  provided.AddCommandVoid(&Arm::Beep, arm, "D");
  // error: given a method and an object of another class
  provided.AddCommandVoid(&Arm::Stop, other, "E");
  // error: given a const object and a method that is not const
  provided.AddCommandVoid(&Arm::Stop, fixed, "F");
}

void OtherForms(tendon::ProvidedInterface& provided, Arm* arm, const tendon::StateTable& table) {
  // error: given a function with an argument; a void command or handler needs void f(); add
  provided.AddCommandVoid(&Arm::MoveTo, arm, "G");
  // error: given a function with a result; a void command or handler needs
  provided.AddCommandVoid(&Arm::Get, arm, "H");
  // error: a void command or handler needs void f()
  provided.AddCommandVoid(&Arm::Move, arm, "I");
  // error: given a function without an argument; a write command or handler needs
  provided.AddCommandWrite(&Arm::Stop, arm, "J");
  // error: an argument T& that is not const is a result
  provided.AddCommandWrite(&Arm::Read, arm, "K", kThreadSafe);
  // error: given a function with an argument and a result; a write command or handler needs
  provided.AddCommandWrite(&Arm::Ask, arm, "L");
  // error: with a T&& argument; a write command or handler needs
  provided.AddCommandWrite(&Arm::Take, arm, "M");
  // error: given a function without a result; a void-return or read command needs
  provided.AddCommandVoidReturn(&Arm::Stop, arm, "N");
  // error: given a function with an argument that it cannot change; a void-return or read
  provided.AddCommandVoidReturn(&Arm::MoveTo, arm, "O");
  // error: given a function with an argument and a result; a void-return or read command needs
  provided.AddCommandRead(&Arm::Ask, arm, "P", kThreadSafe);
  // error: given a function with several arguments; a void-return or read command needs
  provided.AddCommandVoidReturn(&Arm::Move, arm, "Q");
  // error: given a function without an argument and a result; a write-return or qualified-read
  provided.AddCommandWriteReturn([] {}, "R");
  // error: given a function without a result; a write-return or qualified-read
  provided.AddCommandWriteReturn([](int) {}, "S");
  // error: given a function without an argument; a write-return or qualified-read
  provided.AddCommandQualifiedRead(&Arm::Get, arm, "T", kThreadSafe);
  // error: given a function with other arguments; a write-return or qualified-read
  provided.AddCommandWriteReturn(&Arm::Move, arm, "U");
  // error: given a function with other arguments; a qualified read of a table needs
  provided.AddCommandQualifiedRead(
      table, arm->row, [](const Goal&, double) {}, "V");
  // error: given a function for a row of another type
  provided.AddCommandQualifiedRead(table, arm->row, &Arm::Scaled, "W");
  // error: given a function without a result; a write-return or qualified-read
  provided.AddCommandFilteredWrite([](double) {}, [](double) {}, "X");
  // error: given a filter whose result is not the argument of the command
  provided.AddCommandFilteredWrite([](int cm) { return cm / 100.0; }, [](int) {}, "XA");
  // error: given a lambda that captures something as a filter or as the function of a row
  provided.AddCommandFilteredWrite([arm](double in) { return in + arm->speed; }, [](double) {},
                                   "XB");
  // error: given a method as a filter or as the function of a row
  provided.AddCommandFilteredWrite(
      &Arm::Ask, [](double) {}, "XC");
  // error: given a lambda that captures something as a filter or as the function of a row
  provided.AddCommandQualifiedRead(
      table, arm->row, [n = 0](const Goal&, int) mutable { return ++n; }, "XD");
}

void OtherUses(tendon::ProvidedInterface& provided, tendon::RequiredInterface& required, Arm* arm) {
  // error: given a method that is not const, or a mutable lambda; a read needs
  provided.AddCommandRead(&Arm::Read, arm, "Y", kThreadSafe);
  // error: given a method that is not const, or a mutable lambda; a read needs
  provided.AddCommandQualifiedRead([](int in) mutable { return in; }, "Z", kThreadSafe);
  // error: given a read without the tag tendon::kThreadSafe
  provided.AddCommandRead(&Arm::Get, arm, "AA");

  // error: T is a pointer
  provided.AddCommandWrite([](const char* /*text*/) {}, "BA");
  // error: T is a character
  provided.AddCommandVoidReturn([]() -> char { return 'a'; }, "BB");
  // error: T is a view
  provided.AddCommandWrite([](std::string_view /*text*/) {}, "BC", kThreadSafe);
  // error: T is not described
  provided.AddCommandRead([]() -> std::shared_ptr<const Other> { return {}; }, "BD", kThreadSafe);

  // error: given a function with an argument; a void command or handler needs
  required.AddEventHandlerVoid([](int) {}, "A");
  // error: given a function without an argument; a write command or handler needs
  required.AddEventHandlerWrite([] {}, "B", kThreadSafe);
  // error: T is a pointer
  required.AddEventHandlerWrite([](std::shared_ptr<int> /*number*/) {}, "C");
}
