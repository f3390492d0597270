#pragma once

#include <tests/support/folder.h>

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace tendon::test {

/// Creates locales for tests of numbers. Installed locales and their Debian sources differ between
/// machines, so they are not used. Each locale has only the number format of its language. The
/// program uses the last chosen locale until this object is destroyed; child programs find the
/// locales by LOCPATH. Create only one object at a time, because the locale is global.
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

  /// "C", "en_US", a German and a French locale; the last two have a decimal comma.
  static const std::vector<std::string>& Names() {
    static const std::vector<std::string> names{"C", "en_US", "de_DE", "fr_FR"};
    return names;
  }

  /// Uses one of Names(). Returns false if localedef, a part of the C library, cannot create it.
  bool Use(const std::string& name) {
    // The C library remembers a missing locale, so create it before the first use.
    if (name != "C" && !std::filesystem::exists(folder_.path() / name)) Make(name);
    return std::setlocale(LC_ALL, name.c_str()) != nullptr;
  }

  [[nodiscard]] std::string path() const { return folder_.path().string(); }

 private:
  struct NumberWords {
    std::string point;
    std::string between_thousands;
  };

  void Make(const std::string& name) const {
    static const std::map<std::string, NumberWords> words{
        {"en_US", {".", ","}}, {"de_DE", {",", "."}}, {"fr_FR", {",", " "}}};
    const auto& [point, between_thousands] = words.at(name);
    const std::string locale = (folder_.path() / (name + ".source")).string();
    std::ofstream(locale) << "LC_NUMERIC\ndecimal_point \"" << point << "\"\nthousands_sep \""
                          << between_thousands << "\"\ngrouping 3;3\nEND LC_NUMERIC\n";
    const std::string letters = (folder_.path() / "ascii").string();
    std::ofstream(letters) << "<code_set_name> ANSI_X3.4-1968\n<mb_cur_max> 1\n<escape_char> /\n"
                              "CHARMAP\n"
                           << AsciiLetters() << "END CHARMAP\n";
    // With -c, localedef only warns that the other categories are those of C.
    const std::string line = "localedef -c -f '" + letters + "' -i '" + locale + "' '" +
                             (folder_.path() / name).string() + "' >/dev/null 2>&1";
    [[maybe_unused]] const int warned = std::system(line.c_str());
  }

  static std::string AsciiLetters() {
    constexpr char kDigits[] = "0123456789ABCDEF";
    std::string letters;
    for (int code = 0; code < 128; ++code) {
      const std::string number{kDigits[code / 16], kDigits[code % 16]};
      letters += "<U00" + number + "> /x" + number + "\n";
    }
    return letters;
  }

  Folder folder_;
  std::string former_ = std::setlocale(LC_ALL, nullptr);
  std::string former_path_;
};

}  // namespace tendon::test
