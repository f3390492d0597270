#include <tendon/security/certificate_authority.h>

#include <tendon/base/name.h>
#include <tendon/base/os/file.h>
#include <tendon/base/os/process.h>
#include <tendon/base/text.h>
#include <tendon/security/authority_folder.h>
#include <tendon/security/certificate_builder.h>
#include <tendon/security/pem.h>

#include <algorithm>
#include <optional>
#include <system_error>

namespace tendon {
namespace {

namespace fs = std::filesystem;
using std::chrono::sys_seconds;

constexpr std::chrono::years kLifeOfAuthority(10);

sys_seconds Now() {
  return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
}

/// While this object exists, other programs cannot change the CA.
class Lock {
 public:
  explicit Lock(const AuthorityFolder& folder) : file_(folder.lock()) {
    const std::string mine = std::to_string(os::RandomNumber());
    const auto held = os::ReadOrMakePrivateFile(file_, mine);
    is_held_ = held && *held == mine;
    if (!held) why_ = held.error();
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;
  ~Lock() {
    std::error_code ignored;
    if (is_held_) fs::remove(file_, ignored);
  }

  [[nodiscard]] Result<void> Held() const {
    if (is_held_) return {};
    if (why_) return *why_;
    return Error{ErrorCode::kFailed,
                 "another program is changing this CA: try again; if no such program runs, an "
                 "earlier one was interrupted: remove " +
                     file_.string()};
  }

 private:
  const fs::path file_;
  bool is_held_ = false;
  std::optional<Error> why_;
};

/// The certificate and key with which a CA signs.
struct Authority {
  openssl::CertificateHandle certificate;
  openssl::Key key;

  [[nodiscard]] openssl::Signer signer() const { return {*certificate, *key}; }
};

Result<Authority> Read(const AuthorityFolder& folder) {
  auto certificate = ReadAuthority(folder);
  if (!certificate) return certificate.error();
  auto key = ReadPrivateKey(folder.key());
  if (!key) return key.error();
  if (X509_check_private_key(certificate->get(), key->get()) != 1) {
    return Error{ErrorCode::kInvalid, folder.key().string() + " does not belong to " +
                                          folder.certificate().string() +
                                          ": restore both files from the same copy"};
  }
  return Authority{.certificate = *std::move(certificate), .key = *std::move(key)};
}

Result<void> Check(const CertificateAuthority::Request& request, sys_seconds last) {
  if (auto name = CheckName("certificate", request.name); !name) return name;
  if (request.validity < std::chrono::days(1)) {
    return Error{ErrorCode::kInvalid, "a certificate is valid for at least 1 day"};
  }
  if (Now() + request.validity > last) {
    return Error{ErrorCode::kInvalid, "a certificate for " +
                                          std::to_string(request.validity.count()) +
                                          " days would outlive its CA, which expires on " +
                                          DateText(last) + ": give fewer days"};
  }
  for (const std::string& host : request.hosts) {
    if (openssl::IsHost(host)) continue;
    return Error{ErrorCode::kInvalid, "host " + Quoted(host, 64) +
                                          ": expected a name such as robot.local or an address"};
  }
  return {};
}

/// The files of an issued certificate.
struct PersonalFiles {
  PersonalFiles(const std::string& name, const fs::path& folder)
      : certificate(folder / (name + ".crt")), key(folder / (name + ".key")) {}

  fs::path certificate;
  fs::path key;
};

Result<void> RequireFree(const fs::path& file) {
  std::error_code reason;
  if (fs::symlink_status(file, reason).type() == fs::file_type::not_found) return {};
  return Error{ErrorCode::kExists, file.string() +
                                       " already exists, and is not overwritten: choose another "
                                       "folder with --out, or remove it"};
}

/// The issued certificates with one name, and the names of all issued certificates.
struct FoundAuthority {
  std::vector<openssl::CertificateHandle> certificates;
  std::vector<std::string> names;
};

Error Unreadable(const fs::path& copy, const std::string& why) {
  return {ErrorCode::kInvalid,
          copy.string() + " cannot be read (" + why +
              "), so nothing was revoked: restore this file from a copy of the folder of the CA"};
}

Result<FoundAuthority> Find(const AuthorityFolder& folder, const std::string& name) {
  FoundAuthority found;
  std::error_code reason;
  fs::directory_iterator copies(folder.issued(), reason);
  for (; copies != fs::directory_iterator(); copies.increment(reason)) {
    const fs::path& copy = copies->path();
    if (copy.extension() != ".crt") continue;  // a half-written file left by a killed program
    const auto text = ReadSmallFile(copy);
    if (!text) return Unreadable(copy, text.error().message);
    auto certificate = openssl::ReadCertificate(*text);
    if (!certificate) return Unreadable(copy, "it is not a certificate");
    const auto described = openssl::Describe(*certificate);
    if (!described) return Unreadable(copy, described.error().message);
    found.names.push_back(described->name);
    if (described->name == name) found.certificates.push_back(std::move(certificate));
  }
  if (reason) return Unreadable(folder.issued(), reason.message());
  return found;
}

/// Returns the certificates with this name that are not revoked. Fails if there is no such
/// certificate; the error says why.
Result<std::vector<openssl::CertificateHandle>> FindValid(const AuthorityFolder& folder,
                                                          X509_CRL& revoked,
                                                          const std::string& name) {
  Result<FoundAuthority> found = Find(folder, name);
  if (!found) return found.error();
  if (found->certificates.empty()) {
    return Error{ErrorCode::kNotFound, "the CA in " + folder.path.string() +
                                           " has issued no certificate to " + Quoted(name, 64) +
                                           DidYouMean(name, found->names)};
  }
  std::erase_if(found->certificates, [&revoked](const auto& certificate) {
    X509_REVOKED* entry = nullptr;
    return X509_CRL_get0_by_cert(&revoked, &entry, certificate.get()) == 1;
  });
  if (found->certificates.empty()) {
    return Error{ErrorCode::kExists, "all certificates of '" + name + "' are already revoked"};
  }
  return std::move(found->certificates);
}

std::vector<std::string> SerialsOf(const std::vector<openssl::CertificateHandle>& certificates) {
  std::vector<std::string> serials;
  for (const auto& certificate : certificates) serials.push_back(openssl::SerialOf(*certificate));
  std::sort(serials.begin(), serials.end());
  return serials;
}

}  // namespace

Result<void> CertificateAuthority::CheckInit(const fs::path& folder) {
  const AuthorityFolder files{folder};
  std::error_code reason;
  if (fs::exists(files.certificate(), reason)) {
    return Error{ErrorCode::kExists,
                 "there is a CA in " + folder.string() +
                     " already; a new CA would make all its certificates invalid: use the existing "
                     "CA, or choose another folder with --ca"};
  }
  if (fs::exists(files.key(), reason)) {
    return Error{ErrorCode::kExists,
                 "the CA in " + folder.string() +
                     " is incomplete, because the file ca.crt is missing: restore that file; or, "
                     "if no certificate was issued yet, remove the folder and try again"};
  }
  if (fs::exists(folder, reason) && !fs::is_empty(folder, reason)) {
    return Error{ErrorCode::kExists,
                 folder.string() + " contains other files: choose another folder with --ca"};
  }
  return {};
}

Result<CertificateAuthority> CertificateAuthority::Init(const fs::path& folder) {
  const AuthorityFolder files{folder};
  if (auto good = CheckInit(folder); !good) return good.error();
  std::error_code reason;
  if (auto made = MakePrivateFolder(folder); !made) return made.error();
  fs::permissions(folder, fs::perms::owner_all, reason);
  if (auto made = MakePrivateFolder(files.issued()); !made) return made.error();
  const Lock lock(files);
  if (auto held = lock.Held(); !held) return held.error();

  const openssl::Key key = openssl::MakeKey();
  const sys_seconds last = Now() + kLifeOfAuthority;
  const auto certificate = openssl::MakeAuthority(*key, last);
  const auto revoked = openssl::MakeRevocationList(nullptr, {}, {*certificate, *key});
  if (auto done = WriteKey(files.key(), *key); !done) return done.error();
  if (auto done = WritePrivateFile(files.revoked(), openssl::PemOf(*revoked)); !done) {
    return done.error();
  }
  if (auto done = WritePrivateFile(files.certificate(), openssl::PemOf(*certificate)); !done) {
    return done.error();
  }
  return CertificateAuthority(folder, last);
}

Result<CertificateAuthority> CertificateAuthority::Open(const fs::path& folder) {
  const auto authority = Read({folder});
  if (!authority) return authority.error();
  return CertificateAuthority(folder,
                              openssl::TimeOf(X509_get0_notAfter(authority->certificate.get())));
}

Result<void> CertificateAuthority::CheckIssue(const Request& request, const fs::path& out) const {
  if (auto good = Check(request, not_after_); !good) return good;
  const PersonalFiles files(request.name, out);
  for (const fs::path& file : {files.certificate, files.key}) {
    if (auto is_free = RequireFree(file); !is_free) return is_free;
  }
  return {};
}

Result<CertificateAuthority::IssuedCertificate> CertificateAuthority::Issue(
    const Request& request, const fs::path& out) const {
  const AuthorityFolder files{folder_};
  const auto authority = Read(files);
  if (!authority) return authority.error();
  const Lock lock(files);
  if (auto held = lock.Held(); !held) return held.error();
  if (auto good = CheckIssue(request, out); !good) return good.error();
  if (auto made = MakePrivateFolder(out); !made) return made.error();

  const openssl::Key key = openssl::MakeKey();
  const auto certificate =
      openssl::MakeCertificate(request, *key, Now() + request.validity, authority->signer());
  const std::string text = openssl::PemOf(*certificate);
  const fs::path copy = files.issued() / (openssl::SerialOf(*certificate) + ".crt");
  // Writes the copy first, because a certificate can be revoked only if there is a copy.
  if (auto done = WritePrivateFile(copy, text); !done) return done.error();
  const PersonalFiles issued(request.name, out);
  if (auto done = WriteKey(issued.key, *key); !done) return done.error();
  if (auto done = WritePrivateFile(issued.certificate, text); !done) return done.error();
  auto described = openssl::Describe(*certificate);
  if (!described) return described.error();
  return IssuedCertificate{.certificate = *std::move(described),
                           .certificate_file = issued.certificate,
                           .key_file = issued.key};
}

Result<std::vector<std::string>> CertificateAuthority::Revocable(const std::string& name) const {
  const AuthorityFolder files{folder_};
  const auto former = ReadRevoked(files);
  if (!former) return former.error();
  const auto valid = FindValid(files, **former, name);
  if (!valid) return valid.error();
  return SerialsOf(*valid);
}

Result<std::vector<std::string>> CertificateAuthority::Revoke(const std::string& name) const {
  const AuthorityFolder files{folder_};
  const auto authority = Read(files);
  if (!authority) return authority.error();
  const Lock lock(files);
  if (auto held = lock.Held(); !held) return held.error();
  const auto former = ReadRevoked(files);
  if (!former) return former.error();
  const auto valid = FindValid(files, **former, name);
  if (!valid) return valid.error();
  std::vector<const X509*> fresh;
  for (const auto& certificate : *valid) fresh.push_back(certificate.get());
  const auto list = openssl::MakeRevocationList(former->get(), fresh, authority->signer());
  if (auto done = WritePrivateFile(files.revoked(), openssl::PemOf(*list)); !done) {
    return done.error();
  }
  return SerialsOf(*valid);
}

}  // namespace tendon
