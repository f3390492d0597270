#include <tendon/security/certificate.h>

#include <tendon/security/pem.h>

#include <array>
#include <cstdio>

namespace tendon {

std::string_view ToString(Holder holder) noexcept {
  return holder == Holder::kProcess ? "process" : "person";
}

Result<Certificate> ParseCertificate(std::string_view pem) {
  if (pem.size() > kMaxCertificateSize) {
    return Error{ErrorCode::kInvalid, "a text of " + std::to_string(pem.size()) +
                                          " bytes is not a certificate; the longest has " +
                                          std::to_string(kMaxCertificateSize)};
  }
  const auto read = openssl::ReadCertificate(pem);
  if (!read) return Error{ErrorCode::kInvalid, "the text is not a certificate (PEM)"};
  return openssl::Describe(*read);
}

std::string DateText(std::chrono::sys_seconds time) {
  const auto day = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss clock(time - day);
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%04d-%02u-%02u %02d:%02d:%02dZ", int{date.year()},
                unsigned{date.month()}, unsigned{date.day()},
                static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()),
                static_cast<int>(clock.seconds().count()));
  return text.data();
}

}  // namespace tendon
