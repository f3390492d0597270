#include <gcm_console/output/table.h>
#include <gcm_console/verbs/common_options.h>
#include <gcm_console/verbs/verb.h>
#include <program/command_line.h>
#include <tendon/security/certificate_authority.h>
#include <tendon/security/certificate_check.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

namespace console {
namespace {

namespace fs = std::filesystem;
using program::ExitCode;
using tendon::CertificateAuthority;
using tendon::Result;

/// The arguments of all subcommands of `gcm cert`. Each subcommand uses some of them.
struct CertArguments {
  std::string name;
  std::string file;
  std::string role;
  std::string out = ".";
  std::vector<std::string> hosts;
  int days = 365;
  bool is_process = false;
  bool is_dry = false;  ///< only print what would be done
};

/// Returns the folder of the CA.
fs::path Authority(const Context& context) {
  return program::AuthorityOf(context.settings().network);
}

nlohmann::ordered_json CertificateJson(const tendon::Certificate& certificate) {
  return {{"name", certificate.name},
          {"role", ToString(certificate.role)},
          {"holder", ToString(certificate.holder)},
          {"serial", certificate.serial},
          {"not_before", tendon::DateText(certificate.not_before)},
          {"not_after", tendon::DateText(certificate.not_after)}};
}

/// Prints a certificate as a table. `more` contains further rows.
void PrintText(Context& context, const tendon::Certificate& certificate,
               const std::vector<std::vector<std::string>>& more) {
  Table table({"WHAT", "VALUE"});
  table.Add({"name", certificate.name});
  table.Add({"role", std::string(ToString(certificate.role))});
  table.Add({"holder", std::string(ToString(certificate.holder))});
  table.Add({"serial", certificate.serial});
  table.Add({"valid until", tendon::DateText(certificate.not_after)});
  for (const auto& row : more) table.Add(row);
  context.Print(table);
}

/// Checks whether `init` would succeed, and prints what it would do.
Result<ExitCode> RehearseInit(Context& context) {
  const fs::path folder = Authority(context);
  if (auto good = CertificateAuthority::CheckInit(folder); !good) return good.error();
  if (context.settings().json) {
    context.PrintJson({{"folder", folder.string()}, {"not_after", nullptr}, {"dry_run", true}});
  } else {
    context.out() << "the CA would be made in " << Plain(folder.string()) << '\n';
  }
  return program::kOk;
}

Result<ExitCode> Init(Context& context, const CertArguments& arguments) {
  if (arguments.is_dry) return RehearseInit(context);
  const auto authority = CertificateAuthority::Init(Authority(context));
  if (!authority) return authority.error();
  const std::string folder = authority->folder().string();
  const std::string last = tendon::DateText(authority->not_after());
  if (context.settings().json) {
    context.PrintJson({{"folder", folder}, {"not_after", last}, {"dry_run", false}});
  } else {
    context.out() << "CA in " << Plain(folder) << ", valid until " << last << '\n';
  }
  return program::kOk;
}

/// Checks whether `issue` would succeed, and prints what it would do. Serial number and times are
/// not printed, because they exist only when the certificate is made.
Result<ExitCode> RehearseIssue(Context& context, const CertificateAuthority& authority,
                               const CertificateAuthority::Request& request, const fs::path& out) {
  if (auto good = authority.CheckIssue(request, out); !good) return good.error();
  const std::string certificate = (out / (request.name + ".crt")).string();
  const std::string key = (out / (request.name + ".key")).string();
  if (context.settings().json) {
    context.PrintJson({{"name", request.name},
                       {"role", ToString(request.role)},
                       {"holder", ToString(request.holder)},
                       {"serial", nullptr},
                       {"not_before", nullptr},
                       {"not_after", nullptr},
                       {"certificate", certificate},
                       {"key", key},
                       {"dry_run", true}});
  } else {
    for (const std::string& file : {certificate, key}) {
      context.out() << Plain(file) << "  would be written\n";
    }
  }
  return program::kOk;
}

Result<ExitCode> Issue(Context& context, const CertArguments& arguments) {
  const auto role = tendon::ParseRole(arguments.role);
  if (!role) return role.error();
  const auto authority = CertificateAuthority::Open(Authority(context));
  if (!authority) return authority.error();
  const auto holder = arguments.is_process ? tendon::Holder::kProcess : tendon::Holder::kPerson;
  const CertificateAuthority::Request request{.name = arguments.name,
                                              .role = *role,
                                              .holder = holder,
                                              .hosts = arguments.hosts,
                                              .validity = std::chrono::days(arguments.days)};
  if (arguments.is_dry) return RehearseIssue(context, *authority, request, arguments.out);
  const auto issued = authority->Issue(request, arguments.out);
  if (!issued) return issued.error();
  const std::string file = issued->certificate_file.string();
  const std::string key = issued->key_file.string();
  if (context.settings().json) {
    auto content = CertificateJson(issued->certificate);
    content["certificate"] = file;
    content["key"] = key;
    content["dry_run"] = false;
    context.PrintJson(content);
  } else {
    PrintText(context, issued->certificate, {{"certificate", Plain(file)}, {"key", Plain(key)}});
  }
  return program::kOk;
}

Result<ExitCode> Check(Context& context, const CertArguments& arguments) {
  const auto now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  const auto checked = tendon::CheckCertificate(arguments.file, Authority(context), now);
  if (!checked) return checked.error();
  if (context.settings().json) {
    auto content = CertificateJson(checked->certificate);
    content["key"] = checked->key ? nlohmann::ordered_json(checked->key->string()) : nullptr;
    content["warning"] = checked->warning;
    context.PrintJson(content);
  } else {
    PrintText(context, checked->certificate,
              {{"key", checked->key ? Plain(checked->key->string()) : "elsewhere"}});
  }
  if (!checked->warning.empty()) {
    context.err() << "gcm: " << Plain(arguments.file) << ' ' << checked->warning << '\n';
  }
  return program::kOk;
}

Result<ExitCode> Revoke(Context& context, const CertArguments& arguments) {
  const auto authority = CertificateAuthority::Open(Authority(context));
  if (!authority) return authority.error();
  const bool is_dry = arguments.is_dry;
  const auto revoked =
      is_dry ? authority->Revocable(arguments.name) : authority->Revoke(arguments.name);
  if (!revoked) return revoked.error();
  const std::string list = (authority->folder() / "crl.pem").string();
  if (context.settings().json) {
    context.PrintJson(
        {{"name", arguments.name}, {"revoked", *revoked}, {"list", list}, {"dry_run", is_dry}});
  } else {
    for (const std::string& serial : *revoked) {
      context.out() << arguments.name << (is_dry ? "  would be revoked  " : "  revoked  ") << serial
                    << '\n';
    }
    if (!is_dry) {
      context.err() << "gcm: copy the revocation list to all other hosts: " << Plain(list) << '\n';
    }
  }
  return program::kOk;
}

void AddIssueOptions(CLI::App& app, CertArguments& arguments) {
  app.add_option("name", arguments.name,
                 "owner of the certificate: a person, or the name of a process")
      ->required();
  app.add_option("--role", arguments.role, "viewer or operator")->required();
  CLI::Option* process = app.add_flag("--process", arguments.is_process,
                                      "the owner is a process (an LCM or a GCM), not a person");
  app.add_option("--host", arguments.hosts, "a name or address at which the process listens")
      ->needs(process)
      ->allow_extra_args(false);
  app.add_option("--days", arguments.days, "how many days the certificate is valid")
      ->transform(CLI::Validator(&program::TransformCount, ""))
      ->check(CLI::Range(1, 3650))
      ->capture_default_str();
  WithKind(app.add_option("--out", arguments.out, "folder for the files NAME.crt and NAME.key"),
           WordKind::kFile)
      ->capture_default_str();
  AddDryRun(app, arguments.is_dry);
}

/// A subcommand of `gcm cert`.
struct CertVerb {
  const char* name;
  const char* summary;
  void (*add_options)(CLI::App& app, CertArguments& arguments);
  Result<ExitCode> (*run)(Context& context, const CertArguments& arguments);
};

constexpr CertVerb kCertVerbs[] = {
    {"init", "make a CA",
     [](CLI::App& app, CertArguments& arguments) { AddDryRun(app, arguments.is_dry); }, &Init},
    {"issue", "make a key and a certificate", &AddIssueOptions, &Issue},
    {"check", "print the owner of a certificate, and whether the certificate is valid",
     [](CLI::App& app, CertArguments& arguments) {
       WithKind(
           app.add_option("file", arguments.file,
                          "the certificate NAME.crt; the key NAME.key must be in the same folder"),
           WordKind::kFile)
           ->required();
     },
     &Check},
    {"revoke", "revoke all certificates of a name",
     [](CLI::App& app, CertArguments& arguments) {
       app.add_option("name", arguments.name, "whose")->required();
       AddDryRun(app, arguments.is_dry);
     },
     &Revoke}};

Verb::Run PrepareCert(CLI::App& app) {
  const auto chosen = std::make_shared<const CertVerb*>(nullptr);
  const auto arguments = std::make_shared<CertArguments>();
  app.require_subcommand(1);
  for (const CertVerb& act : kCertVerbs) {
    CLI::App* part = app.add_subcommand(act.name, act.summary);
    part->fallthrough();
    act.add_options(*part, *arguments);
    part->callback([chosen, &act] { *chosen = &act; });
  }
  return [chosen, arguments](Context& context) { return (*chosen)->run(context, *arguments); };
}

}  // namespace

std::vector<Verb> CertVerbs() {
  return {{"cert", "make and check the certificates of people and processes", &PrepareCert}};
}

}  // namespace console
