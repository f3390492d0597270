#include <tendon/base/os/shared_library.h>

#include <cxxabi.h>
#include <dlfcn.h>
#include <elf.h>
#include <link.h>
#include <tendon/base/text.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>
#include <system_error>
#include <vector>

namespace tendon::os {
namespace {

using Header = ElfW(Ehdr);
using Segment = ElfW(Phdr);
using Entry = ElfW(Dyn);

std::string MachineName(unsigned machine) {
  switch (machine) {
    case EM_X86_64:
      return "x86-64";
    case EM_AARCH64:
      return "aarch64";
    case EM_386:
      return "i386";
    case EM_ARM:
      return "arm";
    case EM_RISCV:
      return "riscv";
    default:
      return "machine " + std::to_string(machine);
  }
}

struct FileHead {
  Header header{};
  std::size_t size = 0;  // bytes read
};

FileHead ReadHead(std::ifstream& file) {
  FileHead head;
  file.read(reinterpret_cast<char*>(&head.header), sizeof(head.header));
  head.size = static_cast<std::size_t>(file.gcount());
  return head;
}

/// The header of this program. The header of a library must fit it.
const Header& OwnHeader() {
  static const Header header = [] {
    std::ifstream file("/proc/self/exe", std::ios::binary);
    return ReadHead(file).header;
  }();
  return header;
}

Error Expected(const std::string& found) {
  return {ErrorCode::kFailed, "expected a shared library for " +
                                  MachineName(OwnHeader().e_machine) + ", found " + found};
}

/// Returns the file size that the header implies: the end of the last part that the header lists.
std::uint64_t ClaimedSize(const Header& header, std::ifstream& file) {
  std::uint64_t end = header.e_shoff + std::uint64_t{header.e_shnum} * header.e_shentsize;
  file.seekg(static_cast<std::streamoff>(header.e_phoff));
  for (unsigned i = 0; i < header.e_phnum; ++i) {
    Segment segment{};
    if (!file.read(reinterpret_cast<char*>(&segment), sizeof(segment))) break;
    end = std::max<std::uint64_t>(end, segment.p_offset + segment.p_filesz);
  }
  return std::max<std::uint64_t>(
      end, header.e_phoff + std::uint64_t{header.e_phnum} * header.e_phentsize);
}

/// The libraries that a library needs, and the folders where it looks for them.
struct Needs {
  std::vector<std::string> names;
  std::string run_path;  // folders separated by ':'
};

/// Reads the sections of a library built for this machine.
class LibraryReader {
 public:
  explicit LibraryReader(const std::filesystem::path& file) : file_(file, std::ios::binary) {
    const Header header = ReadHead(file_).header;
    for (unsigned i = 0; file_ && i < header.e_phnum; ++i) {
      Segment segment{};
      if (Read(header.e_phoff + i * sizeof(segment), segment)) segments_.push_back(segment);
    }
  }

  Needs needs() {
    Needs needs;
    std::uint64_t texts = 0;
    std::vector<Entry> entries;
    for (const Segment& segment : segments_) {
      if (segment.p_type != PT_DYNAMIC) continue;
      Entry entry{};
      for (std::uint64_t at = 0; at < segment.p_filesz; at += sizeof(entry)) {
        if (!Read(segment.p_offset + at, entry) || entry.d_tag == DT_NULL) break;
        if (entry.d_tag == DT_STRTAB) texts = OffsetOf(entry.d_un.d_ptr);
        entries.push_back(entry);
      }
    }
    for (const Entry& entry : entries) {
      const std::uint64_t place = texts + entry.d_un.d_val;
      if (entry.d_tag == DT_NEEDED) needs.names.push_back(ReadText(place));
      const bool is_path = entry.d_tag == DT_RUNPATH || entry.d_tag == DT_RPATH;
      if (is_path) needs.run_path = ReadText(place);
    }
    return needs;
  }

 private:
  template <typename T>
  bool Read(std::uint64_t offset, T& value) {
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(offset));
    return static_cast<bool>(file_.read(reinterpret_cast<char*>(&value), sizeof(value)));
  }
  std::string ReadText(std::uint64_t offset) {
    std::string text;
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(offset));
    std::getline(file_, text, '\0');
    return text;
  }
  /// The offset in the file of the data that is loaded at `address`.
  [[nodiscard]] std::uint64_t OffsetOf(std::uint64_t address) const {
    for (const Segment& one : segments_) {
      const bool is_in = address >= one.p_vaddr && address - one.p_vaddr < one.p_filesz;
      if (one.p_type == PT_LOAD && is_in) return address - one.p_vaddr + one.p_offset;
    }
    return address;
  }

  std::ifstream file_;
  std::vector<Segment> segments_;
};

/// Returns the folders of a run path that contain $ORIGIN. In each, $ORIGIN is replaced by the
/// folder of `file`.
std::vector<std::filesystem::path> FoldersBeside(const std::filesystem::path& file,
                                                 const std::string& run_path) {
  std::vector<std::filesystem::path> folders;
  std::istringstream all(run_path);
  for (std::string folder; std::getline(all, folder, ':');) {
    for (const std::string origin : {"$ORIGIN", "${ORIGIN}"}) {
      const std::size_t at = folder.find(origin);
      if (at == folder.npos) continue;
      folders.emplace_back(folder.replace(at, origin.size(), file.parent_path().string()));
    }
  }
  return folders;
}

/// Loads the libraries beside `original` that its copy could not find, so that the loader knows
/// them by name afterwards. Ignores failures, because loading the copy reports them with a reason.
void LoadNeedsBeside(const std::filesystem::path& original, const std::filesystem::path& copy) {
  const Needs needs = LibraryReader(copy).needs();
  const auto folders = FoldersBeside(original, needs.run_path);
  for (const std::string& name : needs.names) {
    if (folders.empty() || dlopen(name.c_str(), RTLD_LAZY | RTLD_NOLOAD) != nullptr) continue;
    for (const std::filesystem::path& folder : folders) {
      std::error_code ignored;
      if (!std::filesystem::exists(folder / name, ignored)) continue;
      (void)dlopen((folder / name).c_str(), RTLD_NOW | RTLD_LOCAL);
      break;
    }
  }
}

/// Demangles a symbol: returns "tendon::Task::Run()" for "_ZN6tendon4Task3RunEv".
std::string Readable(const std::string& symbol) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), &std::free);
  return status == 0 ? name.get() : symbol;
}

/// Converts the loader's message to an Error.
Error Explained(const std::string& words) {
  constexpr std::string_view kSymbol = "undefined symbol: ";
  constexpr std::string_view kMissing = ": cannot open shared object file";
  if (const auto at = words.find(kSymbol); at != words.npos) {
    std::string symbol = words.substr(at + kSymbol.size());
    symbol.resize(std::min(symbol.size(), symbol.find_first_of(" ,")));
    return {ErrorCode::kFailed, "no library that this library needs has the symbol " +
                                    Readable(symbol) +
                                    "; link the library that has it, and build the plug-in again "
                                    "with this version of Tendon"};
  }
  if (const auto at = words.find(kMissing); at != words.npos) {
    const std::string library = Printable(words.substr(0, at), 256);
    // The names of Tendon's libraries end with their version.
    const bool is_ours = library.starts_with("libtendon_");
    return {
        ErrorCode::kFailed,
        "a library that this library needs is missing: " + library +
            (is_ours ? "; build the plug-in again with this version of Tendon, or install that one"
                     : "; install the missing library, or add its folder to LD_LIBRARY_PATH")};
  }
  return {ErrorCode::kFailed, "the library cannot be loaded: " + Printable(words, 512)};
}

}  // namespace

Result<void> CheckSharedLibrary(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return Expected("a file that cannot be read");
  const auto [header, size] = ReadHead(file);
  if (size == 0) return Expected("an empty file");
  if (size < SELFMAG || std::memcmp(&header, ELFMAG, SELFMAG) != 0) {
    const auto* text = reinterpret_cast<const char*>(&header);
    return Expected("a file that begins with " + Quoted({text, std::min<std::size_t>(size, 16)}));
  }
  if (size < sizeof(header))
    return Expected("a file that ends after " + std::to_string(size) + " B");
  const Header& own = OwnHeader();
  if (header.e_machine != own.e_machine)
    return Expected("one for " + MachineName(header.e_machine));
  if (header.e_ident[EI_CLASS] != own.e_ident[EI_CLASS] ||
      header.e_ident[EI_DATA] != own.e_ident[EI_DATA]) {
    return Expected("a library with another word size or byte order");
  }
  if (header.e_type != ET_DYN) return Expected("an object file or a program");
  std::error_code ignored;
  const std::uint64_t whole = std::filesystem::file_size(path, ignored);
  const std::uint64_t claimed = ClaimedSize(header, file);
  if (whole < claimed) {
    return Expected("an incomplete file: " + std::to_string(whole) + " of " +
                    std::to_string(claimed) + " B");
  }
  return {};
}

Result<void*> LoadSharedLibrary(const std::filesystem::path& file,
                                const std::filesystem::path& original) {
  if (file != original) LoadNeedsBeside(original, file);
  if (void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) return library;
  const char* reason = dlerror();
  return Explained(reason != nullptr ? reason : "the loader gives no reason");
}

void* FindSymbol(void* library, const char* name) noexcept {
  void* const symbol = dlsym(library, name);
  link_map* map = nullptr;
  Dl_info owner{};
  if (symbol == nullptr || dlinfo(library, RTLD_DI_LINKMAP, &map) != 0) return nullptr;
  if (dladdr(symbol, &owner) == 0) return nullptr;
  return reinterpret_cast<ElfW(Addr)>(owner.dli_fbase) == map->l_addr ? symbol : nullptr;
}

std::filesystem::path FileOf(const void* function) {
  Dl_info info{};
  if (dladdr(function, &info) == 0 || info.dli_fname == nullptr) return {};
  return info.dli_fname;
}

}  // namespace tendon::os
