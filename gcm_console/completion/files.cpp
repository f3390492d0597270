#include <gcm_console/completion/files.h>

#include <algorithm>
#include <filesystem>

namespace console {
namespace {

namespace fs = std::filesystem;

/// The names in a folder that begin with the last part of `word`.
std::vector<Completion::Candidate> Files(const std::string& word) {
  const auto slash = word.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : word.substr(0, slash + 1);
  std::vector<Completion::Candidate> files;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, none)) {
    const std::string path = folder + entry.path().filename().string();
    if (!path.starts_with(word)) continue;
    files.push_back({path + (entry.is_directory(none) ? "/" : " "), ""});
  }
  std::sort(files.begin(), files.end(),
            [](const auto& a, const auto& b) { return a.text < b.text; });
  return files;
}

}  // namespace

void AddFiles(Completion& completion, const std::string& word) {
  if (!completion.is_file) return;
  const bool is_option = word.starts_with("--") && word.find('=') != word.npos;
  const std::string begin = is_option ? word.substr(0, word.find('=') + 1) : "";
  completion.candidates = Files(word.substr(begin.size()));
  for (auto& one : completion.candidates) one.text.insert(0, begin);
}

std::string CommonBegin(const std::vector<Completion::Candidate>& candidates) {
  std::string common = candidates.front().text;
  for (const auto& [text, help] : candidates) {
    const auto end = std::mismatch(common.begin(), common.end(), text.begin(), text.end());
    common.erase(end.first, common.end());
  }
  return common;
}

}  // namespace console
