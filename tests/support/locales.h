#pragma once

#include <tests/support/folder.h>

#include <clocale>
#include <cstdlib>
#include <string>
#include <vector>

namespace tendon::test {

/// Locales for tests of numbers, made for them: which are installed differs from machine to
/// machine. The program speaks the last one used, and its own again in the end. One at a time: what
/// it changes is the whole program's.
class Locales {
 public:
  Locales() {
    if (const char* path = std::getenv("LOCPATH")) former_path_ = path;
    setenv("LOCPATH", folder_.path().c_str(), 1);
  }
  Locales(const Locales&) = delete;
  Locales& operator=(const Locales&) = delete;
  ~Locales() {
    std::setlocale(LC_ALL, former_.c_str());
    former_path_.empty() ? unsetenv("LOCPATH") : setenv("LOCPATH", former_path_.c_str(), 1);
  }

  /// "C", "en_US", a German and a French one: two have a decimal comma.
  static const std::vector<std::string>& Names() {
    static const std::vector<std::string> names{"C", "en_US", "de_DE", "fr_FR"};
    return names;
  }

  /// False where it cannot be made: localedef or its sources are missing (Debian: locales).
  bool Use(const std::string& name) {
    if (name == "C") return std::setlocale(LC_ALL, "C") != nullptr;
    const std::string whole = name + ".UTF-8";
    if (std::setlocale(LC_ALL, whole.c_str()) != nullptr) return true;
    const std::string made = (folder_.path() / whole).string();
    const std::string line = "localedef -f UTF-8 -i " + name + " " + made + " >/dev/null 2>&1";
    return std::system(line.c_str()) == 0 && std::setlocale(LC_ALL, whole.c_str()) != nullptr;
  }

  [[nodiscard]] std::string path() const { return folder_.path().string(); }

 private:
  Folder folder_;
  std::string former_ = std::setlocale(LC_ALL, nullptr);
  std::string former_path_;
};

}  // namespace tendon::test
