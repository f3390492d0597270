#pragma once

#include <tendon/base/error.h>
#include <tendon/base/status.h>
#include <tendon/interface/signature.h>
#include <tendon/payload/payload.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>

/// The code of a command or an event handler, as its author gives it: a lambda or another function
/// object, a free function, or a method and its object, with or without `const` and `noexcept`.
///
///     void                          void f()
///     write                         void f(T)
///     void-return, read             U f()      or  void f(U&)
///     write-return, qualified read  U f(T)     or  void f(T, U&)
///     qualified read of a table     U f(R, T)  or  void f(R, T, U&)
///
/// T and R, the row, are taken by value or by const reference. The form with U& reuses the memory
/// of earlier results. The function is stored once, when it is added; connections share it.
namespace tendon::callable {

/// What an author gave: one of the forms above, or a mistake.
enum class Given : std::uint8_t {
  kVoid,
  kWrite,
  kReturn,
  kWriteReturn,
  kRowRead,
  kOtherForm,
  kNoFunction,
  kManyForms,    ///< the call operator is overloaded or generic
  kMethodAlone,  ///< a method without its object
  kNoMethod,     ///< an object, and a function that is not a method
  kOtherObject,  ///< an object of a class that does not have the method
  kConstObject,  ///< a const object, and a method that is not const
};

template <typename T>
concept Input = !std::is_rvalue_reference_v<T> &&
                (!std::is_lvalue_reference_v<T> || std::is_const_v<std::remove_reference_t<T>>);
template <typename T>
concept Output = std::is_lvalue_reference_v<T> && !Input<T>;
template <typename T>
concept Result = !std::is_void_v<T> && !std::is_rvalue_reference_v<T>;

/// A form of a function, and the types in it.
template <Given kForm, typename T = None, typename U = None, typename R = None>
struct Form {
  static constexpr Given kGiven = kForm;
  static constexpr bool kReturns = false;
  using In = std::remove_cvref_t<T>;
  using Out = std::remove_cvref_t<U>;
  using Row = std::remove_cvref_t<R>;
};
/// A form whose result is returned by value.
template <Given kForm, typename T, typename U, typename R = None>
struct ReturningForm : Form<kForm, T, U, R> {
  static constexpr bool kReturns = true;
};

/// The form of a function type without `const`, `&` and `noexcept`.
template <typename Signature>
struct FormOf : Form<Given::kOtherForm> {};
template <>
struct FormOf<void()> : Form<Given::kVoid> {};
template <Input T>
struct FormOf<void(T)> : Form<Given::kWrite, T> {};
template <Output U>
struct FormOf<void(U)> : Form<Given::kReturn, None, U> {};
template <Result U>
struct FormOf<U()> : ReturningForm<Given::kReturn, None, U> {};
template <Input T, Output U>
struct FormOf<void(T, U)> : Form<Given::kWriteReturn, T, U> {};
template <Result U, Input T>
struct FormOf<U(T)> : ReturningForm<Given::kWriteReturn, T, U> {};
template <Input R, Input T, Output U>
struct FormOf<void(R, T, U)> : Form<Given::kRowRead, T, U, R> {};
template <Result U, Input R, Input T>
struct FormOf<U(R, T)> : ReturningForm<Given::kRowRead, T, U, R> {};

/// The form of a function type, and whether the function is const.
template <typename F>
struct SignatureTraits
    : FormOf<void(F, F, F, F)> {  // has C-style variable arguments, or is volatile
  static constexpr bool kIsConst = true;
};
template <typename U, typename... T, bool kNoexcept>
struct SignatureTraits<U(T...) noexcept(kNoexcept)> : FormOf<U(T...)> {
  static constexpr bool kIsConst = false;
};
template <typename U, typename... T, bool kNoexcept>
struct SignatureTraits<U(T...)& noexcept(kNoexcept)> : SignatureTraits<U(T...)> {};
template <typename U, typename... T, bool kNoexcept>
struct SignatureTraits<U(T...) const noexcept(kNoexcept)> : FormOf<U(T...)> {
  static constexpr bool kIsConst = true;
};
template <typename U, typename... T, bool kNoexcept>
struct SignatureTraits<U(T...) const& noexcept(kNoexcept)> : SignatureTraits<U(T...) const> {};

template <typename Method>
struct MethodTraits;
template <typename F, typename Class>
struct MethodTraits<F Class::*> : SignatureTraits<F> {
  using Owner = Class;
};

/// A method and its object.
template <typename Method, typename Object>
struct BoundMethod {
  Method method;
  Object* object;

  template <typename... Arguments>
  decltype(auto) operator()(Arguments&... arguments) const {
    return (object->*method)(arguments...);
  }
};
template <typename Method, typename Object>
BoundMethod(Method, Object*) -> BoundMethod<Method, Object>;

template <typename F>
concept FunctionObject = std::is_class_v<F>;
template <typename F>
concept FunctionObjectOfOneForm = FunctionObject<F> && requires {
  &F::operator();
};

/// What F is, and the types in it.
template <typename F>
struct Traits : Form<Given::kNoFunction> {};
template <typename F>
requires std::is_function_v<F>
struct Traits<F*> : SignatureTraits<F> {
  static constexpr bool kIsConst = true;
};
template <typename F, typename Owner>
requires std::is_function_v<F>
struct Traits<F Owner::*> : Form<Given::kMethodAlone> {
};
template <FunctionObject F>
struct Traits<F> : Form<Given::kManyForms> {};
template <FunctionObjectOfOneForm F>
struct Traits<F> : MethodTraits<decltype(&F::operator())> {};
template <typename Method, typename Object>
struct Traits<BoundMethod<Method, Object>> : Form<Given::kNoMethod> {};
template <typename Method, typename Object>
requires std::is_member_function_pointer_v<Method>
struct Traits<BoundMethod<Method, Object>> : MethodTraits<Method> {
  using Base = MethodTraits<Method>;
  static constexpr Given kGiven =
      !std::derived_from<std::remove_const_t<Object>, typename Base::Owner> ? Given::kOtherObject
      : std::is_const_v<Object> && !Base::kIsConst                          ? Given::kConstObject
                                                                            : Base::kGiven;
};

/// True for pointers and for std::function, but not for a lambda that converts to a pointer.
template <typename F>
concept CanBeNull = std::is_constructible_v<F, std::nullptr_t> && requires(const F& function) {
  function == nullptr;
};

/// True if the function can use only its arguments and what is global.
template <typename F>
concept Stateless = std::is_pointer_v<F> ||(FunctionObject<F>&& std::is_empty_v<F>);

/// True if copies of the function behave like the function itself.
template <typename F>
inline constexpr bool kIsCopied = std::is_trivially_copyable_v<F>&& Traits<F>::kIsConst;
template <typename Method, typename Object>
inline constexpr bool kIsCopied<BoundMethod<Method, Object>> = true;

/// A function that many connections call. Calls it as (in, out) or (row, in, out), whatever its
/// form is.
template <typename F>
class Handler {
 public:
  /// Throws ConfigurationError if `function` is a null pointer or an empty std::function.
  explicit Handler(F function) : function_(Store(std::move(function))) {
    if constexpr (CanBeNull<F>) {
      if (stored() == nullptr) {
        throw ConfigurationError(
            "the function is null or empty: give a function that can be called");
      }
    }
  }

  template <typename In, typename Out>
  void operator()(const In& in, Out& out) const {
    if constexpr (Form::kGiven == Given::kVoid || Form::kGiven == Given::kReturn) {
      Call(out);
    } else {
      Call(out, in);
    }
  }
  template <typename Row, typename In, typename Out>
  void operator()(const Row& row, const In& in, Out& out) const {
    Call(out, row, in);
  }
  /// Returns the result of a function without arguments.
  decltype(auto) operator()() const { return stored()(); }

 private:
  using Form = Traits<F>;

  template <typename Out, typename... Arguments>
  void Call(Out& out, const Arguments&... arguments) const {
    if constexpr (Form::kReturns) {
      out = stored()(arguments...);
    } else if constexpr (std::same_as<typename Form::Out, None>) {
      stored()(arguments...);
    } else {
      stored()(arguments..., out);
    }
  }

  static auto Store(F function) {
    if constexpr (kIsCopied<F>) {
      return function;
    } else {
      return std::make_shared<F>(std::move(function));
    }
  }
  auto& stored() const {
    if constexpr (kIsCopied<F>) {
      return function_;
    } else {
      return *function_;
    }
  }

  decltype(Store(std::declval<F>())) function_;
};

/// A handler that runs in the thread of its caller.
template <typename F>
class DirectHandler : private Handler<F> {
 public:
  using Handler<F>::Handler;

  template <typename In, typename Out>
  Status operator()(const In& in, Out& out) const {
    Handler<F>::operator()(in, out);
    return Status::kDone;
  }
};

/// A read that returns a shared value instead of a copy.
template <typename Result>
struct SharedValue {};
template <typename T>
struct SharedValue<std::shared_ptr<const T>> {
  using Type = T;
};
template <typename F>
concept SharedRead = Traits<F>::kGiven == Given::kReturn&& Traits<F>::kReturns&& requires {
  typename SharedValue<typename Traits<F>::Out>::Type;
};

constexpr bool IsRead(CommandKind kind) {
  return kind == CommandKind::kRead || kind == CommandKind::kQualifiedRead;
}

/// The form that the function of a command must have.
constexpr Given FormFor(CommandKind kind) {
  switch (kind) {
    case CommandKind::kVoid:
      return Given::kVoid;
    case CommandKind::kWrite:
      return Given::kWrite;
    case CommandKind::kRead:
    case CommandKind::kVoidReturn:
      return Given::kReturn;
    default:
      return Given::kWriteReturn;
  }
}

/// Does not compile if an author gave something that has no form at all.
template <typename F>
consteval void RequireSomeForm() {
  static_assert(Traits<F>::kGiven != Given::kNoFunction,
                "given a value that is not a function; expected a lambda, a free function, or a "
                "method and its object");
  static_assert(Traits<F>::kGiven != Given::kManyForms,
                "given a function object whose call operator is generic or overloaded, or none; "
                "expected one with written types, like [this](const Goal& goal) { ... }");
  static_assert(Traits<F>::kGiven != Given::kMethodAlone,
                "given a method without its object; expected the object after the method, like "
                "(&Arm::Stop, this, \"Stop\")");
  static_assert(Traits<F>::kGiven != Given::kNoMethod,
                "given an object with a function that is not a method; expected a method and its "
                "object, or the function alone");
  static_assert(Traits<F>::kGiven != Given::kOtherObject,
                "given a method and an object of another class; expected an object that has the "
                "method");
  static_assert(Traits<F>::kGiven != Given::kConstObject,
                "given a const object and a method that is not const; expected a const method");
}

template <typename F>
consteval bool RequireConst() {
  static_assert(Traits<F>::kIsConst,
                "given a method that is not const, or a mutable lambda; a read needs a const one, "
                "because it runs in the thread of its caller");
  return true;
}

template <typename F>
consteval void RequireVoid() {
  static_assert(Traits<F>::kGiven != Given::kWrite,
                "given a function with an argument; a void command or handler needs void f(); "
                "add this one as a write");
  static_assert(Traits<F>::kGiven != Given::kReturn,
                "given a function with a result; a void command or handler needs void f(); add "
                "this one as a void-return or read command");
  static_assert(Traits<F>::kGiven == Given::kWrite || Traits<F>::kGiven == Given::kReturn,
                "given a function with several arguments, or with an argument and a result; a "
                "void command or handler needs void f()");
}

template <typename F>
consteval void RequireWrite() {
  static_assert(Traits<F>::kGiven != Given::kVoid,
                "given a function without an argument; a write command or handler needs "
                "void f(T); add this one as void");
  static_assert(Traits<F>::kGiven != Given::kReturn,
                "given a function with a result and no argument (an argument T& that is not "
                "const is a result); a write command or handler needs void f(T) or "
                "void f(const T&)");
  static_assert(Traits<F>::kGiven != Given::kWriteReturn,
                "given a function with an argument and a result; a write command or handler "
                "needs void f(T); add this one as a write-return or qualified-read command");
  static_assert(Traits<F>::kGiven == Given::kVoid || Traits<F>::kGiven == Given::kReturn ||
                    Traits<F>::kGiven == Given::kWriteReturn,
                "given a function with several arguments, or with a T&& argument; a write "
                "command or handler needs void f(T) or void f(const T&)");
}

template <typename F>
consteval void RequireReturn() {
  static_assert(Traits<F>::kGiven != Given::kVoid,
                "given a function without a result; a void-return or read command needs U f() "
                "or void f(U&); add this one as a void command");
  static_assert(Traits<F>::kGiven != Given::kWrite,
                "given a function with an argument that it cannot change; a void-return or read "
                "command needs U f() or void f(U&); add this one as a write command");
  static_assert(Traits<F>::kGiven != Given::kWriteReturn,
                "given a function with an argument and a result; a void-return or read command "
                "needs U f() or void f(U&); add this one as a write-return or qualified-read "
                "command");
  static_assert(Traits<F>::kGiven == Given::kVoid || Traits<F>::kGiven == Given::kWrite ||
                    Traits<F>::kGiven == Given::kWriteReturn,
                "given a function with several arguments; a void-return or read command needs "
                "U f() or void f(U&)");
}

template <typename F>
consteval void RequireWriteReturn() {
  static_assert(Traits<F>::kGiven != Given::kVoid,
                "given a function without an argument and a result; a write-return or "
                "qualified-read command needs U f(T) or void f(T, U&); add this one as a void "
                "command");
  static_assert(Traits<F>::kGiven != Given::kWrite,
                "given a function without a result; a write-return or qualified-read command "
                "needs U f(T) or void f(T, U&); add this one as a write command");
  static_assert(Traits<F>::kGiven != Given::kReturn,
                "given a function without an argument; a write-return or qualified-read command "
                "needs U f(T) or void f(T, U&); add this one as a void-return or read command");
  static_assert(Traits<F>::kGiven == Given::kVoid || Traits<F>::kGiven == Given::kWrite ||
                    Traits<F>::kGiven == Given::kReturn,
                "given a function with other arguments; a write-return or qualified-read command "
                "needs U f(T) or void f(T, U&)");
}

/// Filters and functions of a row run in the threads of all callers at once.
template <typename F>
consteval bool RequireStateless() {
  static_assert(!std::is_member_pointer_v<F>,
                "given a method as a filter or as the function of a row; expected a lambda or a "
                "free function, because it runs in the thread of its caller");
  static_assert(Stateless<F> || std::is_member_pointer_v<F>,
                "given a lambda that captures something as a filter or as the function of a row; "
                "expected one that uses only its arguments, because it runs in the thread of its "
                "caller");
  return true;
}

/// Does not compile if an author gave a function of another form than the command needs.
template <typename F, Given kExpected>
consteval void RequireForm() {
  if constexpr (Traits<F>::kGiven > Given::kOtherForm) {
    RequireSomeForm<F>();
  } else if constexpr (kExpected == Given::kVoid) {
    RequireVoid<F>();
  } else if constexpr (kExpected == Given::kWrite) {
    RequireWrite<F>();
  } else if constexpr (kExpected == Given::kReturn) {
    RequireReturn<F>();
  } else if constexpr (kExpected == Given::kWriteReturn) {
    RequireWriteReturn<F>();
  } else {
    static_assert(Traits<F>::kGiven == kExpected,
                  "given a function with other arguments; a qualified read of a table needs "
                  "U f(const R&, T) or void f(const R&, T, U&), where R is the type of the "
                  "variable");
  }
}

}  // namespace tendon::callable

namespace tendon {

/// A function that can be the code of a command, or of an event handler, of this kind.
template <typename F, CommandKind kKind>
concept CommandFunction =
    callable::Traits<F>::kGiven == callable::FormFor(kKind) &&
    (!callable::IsRead(kKind) || callable::Traits<F>::kIsConst) &&
    Payload<typename callable::Traits<F>::In>&& Payload<typename callable::Traits<F>::Out>;

/// `static_assert(RequireCommandFunction<F, kKind>())` gives one sentence if F is not a
/// CommandFunction: what was given, and what is expected.
template <typename F, CommandKind kKind>
consteval bool RequireCommandFunction() {
  using Traits = callable::Traits<F>;
  if constexpr (Traits::kGiven != callable::FormFor(kKind)) {
    callable::RequireForm<F, callable::FormFor(kKind)>();
  } else {
    if constexpr (callable::IsRead(kKind)) static_assert(callable::RequireConst<F>());
    return RequirePayload<typename Traits::In>() && RequirePayload<typename Traits::Out>();
  }
  return true;
}

/// Like CommandFunction, for a qualified read of a variable of type Row in a state table.
template <typename F, typename Row>
concept RowFunction =
    callable::Stateless<F> && callable::Traits<F>::kGiven ==
    callable::Given::kRowRead&& std::same_as<typename callable::Traits<F>::Row, Row>&&
        Payload<typename callable::Traits<F>::In>&& Payload<typename callable::Traits<F>::Out>;

template <typename F, typename Row>
consteval bool RequireRowFunction() {
  using Traits = callable::Traits<F>;
  if constexpr (std::is_member_pointer_v<F>) {
    return callable::RequireStateless<F>();
  } else if constexpr (Traits::kGiven != callable::Given::kRowRead) {
    callable::RequireForm<F, callable::Given::kRowRead>();
    return true;
  } else {
    static_assert(callable::RequireStateless<F>());
    static_assert(std::same_as<typename Traits::Row, Row>,
                  "given a function for a row of another type; expected const R&, where R is the "
                  "type of the variable");
    return RequirePayload<typename Traits::In>() && RequirePayload<typename Traits::Out>();
  }
}

/// A filter for a write command with the code Callable.
template <typename Filter, typename Callable>
concept FilterFor =
    callable::Stateless<Filter> && CommandFunction<Filter, CommandKind::kWriteReturn> &&
    CommandFunction<Callable, CommandKind::kWrite> &&
    std::same_as < typename callable::Traits<Filter>::Out,
typename callable::Traits<Callable>::In > ;

template <typename Filter, typename Callable>
consteval bool RequireFilter() {
  if constexpr (std::is_member_pointer_v<Filter>) {
    return callable::RequireStateless<Filter>();
  } else if constexpr (CommandFunction<Filter, CommandKind::kWriteReturn> &&
                       CommandFunction<Callable, CommandKind::kWrite>) {
    static_assert(std::same_as<typename callable::Traits<Filter>::Out,
                               typename callable::Traits<Callable>::In>,
                  "given a filter whose result is not the argument of the command; expected the "
                  "same type, because nothing is converted");
    return callable::RequireStateless<Filter>();
  } else {
    return RequireCommandFunction<Filter, CommandKind::kWriteReturn>() &&
           RequireCommandFunction<Callable, CommandKind::kWrite>();
  }
}

}  // namespace tendon
