#include "support/program.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "support/wait.h"

namespace {

namespace fs = std::filesystem;

std::string Content(const std::string& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void RedirectTo(const std::string& file, int descriptor) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(opened, descriptor);
  close(opened);
}

/// In the child.
[[noreturn]] void Become(const Program::Words& command,
                         const std::map<std::string, std::string>& environment,
                         const std::string& folder) {
  RedirectTo(folder + "/out", STDOUT_FILENO);
  RedirectTo(folder + "/err", STDERR_FILENO);
  for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execv(words[0], words.data());
  _exit(127);
}

}  // namespace

Program::Program(const Words& command, const std::map<std::string, std::string>& environment) {
  std::string folder = (fs::temp_directory_path() / "tendon-program-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) throw std::runtime_error("no folder for " + command[0]);
  folder_ = folder;
  pid_ = fork();
  if (pid_ == 0) Become(command, environment, folder_);
}

Program::~Program() {
  if (!exit_code_) {
    Signal(SIGKILL);
    Wait();
  }
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void Program::Signal(int signal) const { kill(pid_, signal); }

std::optional<int> Program::Wait(std::chrono::seconds patience) {
  EventuallyTrue(
      [this] {
        int status = 0;
        if (exit_code_ || waitpid(pid_, &status, WNOHANG) != pid_) return exit_code_.has_value();
        exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        return true;
      },
      patience);
  return exit_code_;
}

std::string Program::out() const { return Content(folder_ + "/out"); }
std::string Program::err() const { return Content(folder_ + "/err"); }

Outcome RunProgram(const Program::Words& command,
                   const std::map<std::string, std::string>& environment) {
  Program program(command, environment);
  const auto exit_code = program.Wait();
  return {exit_code.value_or(-1), program.out(), program.err()};
}

int FreePort() {
  const int listener = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  bind(listener, reinterpret_cast<sockaddr*>(&address), size);
  getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size);
  close(listener);
  return ntohs(address.sin_port);
}
