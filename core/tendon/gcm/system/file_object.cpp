#include <tendon/gcm/system/file_object.h>

#include <tendon/base/text.h>
#include <tendon/gcm/system_file.h>
#include <tendon/payload/json/json_place.h>

#include <algorithm>

namespace tendon::file {

void Refuse(const std::string& place, const std::string& reason) {
  throw FileError{place, place.empty() ? reason : place + ": " + reason};
}

std::string Shown(const Json& value) {
  if (!value.is_string()) return KindOf(value);
  return "string " + Quoted(value.get_ref<const std::string&>(), 64);
}

FileObject::FileObject(const Json& object, std::string place, const std::vector<std::string>& keys)
    : object_(object), place_(std::move(place)) {
  if (!object.is_object()) Refuse(place_, "expected an object, got " + Shown(object));
  for (const auto& [key, value] : object.items()) {
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    const std::string shown = Printable(key, 64);
    const std::string reason = "unknown key '" + shown + "'" + DidYouMean(shown, keys);
    throw FileError{Place(shown), place_.empty() ? reason : place_ + ": " + reason};
  }
}

std::string FileObject::Place(const std::string& key) const {
  return place_.empty() ? key : place_ + "." + key;
}

const Json* FileObject::Find(const std::string& key) const {
  const auto found = object_.find(key);
  return found == object_.end() ? nullptr : &*found;
}

void FileObject::Require(const std::string& key) const {
  if (Find(key) == nullptr) Refuse(place_, "key '" + key + "' is missing");
}

const Json& FileObject::Get(const std::string& key) const {
  Require(key);
  return *Find(key);
}

std::string FileObject::Text(const std::string& key) const {
  const Json& value = Get(key);
  if (!value.is_string()) Refuse(Place(key), "expected string, got " + Shown(value));
  return value.get<std::string>();
}

std::string FileObject::Name(const std::string& key, const std::string& what) const {
  std::string name = Text(key);
  if (auto checked = CheckName(what, name); !checked) Refuse(Place(key), checked.error().message);
  return name;
}

InterfaceName FileObject::Interface(const std::string& key) const {
  auto name = ParseInterfaceName(Text(key));
  if (!name) Refuse(Place(key), name.error().message);
  return *std::move(name);
}

std::string FileObject::Comment() const {
  return Find("comment") == nullptr ? "" : Printable(Text("comment"));
}

double FileObject::Number(const std::string& key, const std::string& unit, double otherwise) const {
  const Json* value = Find(key);
  if (value == nullptr) return otherwise;
  if (!value->is_number()) {
    Refuse(Place(key), "expected number (" + unit + "), got " + Shown(*value));
  }
  return value->get<double>();
}

bool FileObject::Flag(const std::string& key) const {
  const Json* value = Find(key);
  if (value == nullptr) return false;
  if (!value->is_boolean()) Refuse(Place(key), "expected true or false, got " + Shown(*value));
  return value->get<bool>();
}

double FileObject::Period(const std::string& key) const {
  constexpr double kShortest = 10e-6;
  constexpr double kLongest = 3600.0;
  if (Find(key) == nullptr) return 0.0;
  const double period = Number(key, "seconds", 0.0);
  if (!(period >= kShortest && period <= kLongest)) {
    Refuse(Place(key), "period must be 10 us..3600 s, got " + Get(key).dump());
  }
  return period;
}

void UniqueNames::Add(const std::string& name, const std::string& place) {
  if (!known_.insert(name).second) Refuse(place, what_ + " '" + name + "' already exists");
}

std::string ReadClassName(const FileObject& object, const std::string& key) {
  std::string name = object.Text(key);
  if (name.empty()) Refuse(object.Place(key), "class name is empty");
  const std::string shown = Printable(name, 64);
  if (Printable(name) != name) {
    Refuse(object.Place(key),
           "class name '" + shown + "' has a character that is not allowed in names");
  }
  return name;
}

std::string ConfigurationText(const Json& configuration, const std::string& place) {
  if (!configuration.is_object()) Refuse(place, "expected an object, got " + Shown(configuration));
  constexpr bool kAsciiOnly = true;
  std::string text = configuration.dump(-1, ' ', kAsciiOnly);
  if (text.size() > SystemFile::kMaxConfiguration) {
    Refuse(place, "expected a configuration of at most " +
                      std::to_string(SystemFile::kMaxConfiguration) + " bytes, got " +
                      std::to_string(text.size()));
  }
  return text;
}

void CheckLibrary(const std::string& library, const std::string& place) {
  const std::string shown = "library " + Quoted(library, 64) + " ";
  if (library.empty())
    Refuse(place, "library name is empty; if there is no library, leave the key out");
  if (library.find('/') != library.npos || library.find('\\') != library.npos ||
      library.find("..") != library.npos) {
    Refuse(place, shown +
                      "is a path; give only the name of the plug-in, which is searched in the "
                      "plug-in folders");
  }
  if (Printable(library) != library)
    Refuse(place, shown + "has a character that is not allowed in names");
}

Error ErrorOf(const FileError& mistake, std::string_view text, const std::string& source) {
  const std::string place = PlaceInJson(text, mistake.place);
  return {ErrorCode::kInvalid, source + ": " + place + ": " + mistake.text};
}

}  // namespace tendon::file
