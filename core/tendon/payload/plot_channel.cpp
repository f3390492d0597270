#include <tendon/base/name.h>
#include <tendon/payload/body_reader.h>
#include <tendon/payload/plot_channel.h>

#include <charconv>

namespace tendon {
namespace {

using payload::CdrReader;

bool IsChannel(const Schema& schema) {
  return schema.is_number() || schema.kind() == Schema::Kind::kEnum ||
         schema.kind() == Schema::Kind::kDuration;
}

bool IsList(const Schema& schema) {
  return schema.kind() == Schema::Kind::kArray || schema.kind() == Schema::Kind::kSequence;
}

std::string UnitOf(const Schema& number, const std::string& unit) {
  return unit.empty() && number.kind() == Schema::Kind::kDuration ? "s" : unit;
}

/// Reads the next value as a number.
std::optional<ChannelValue> ReadNumber(const Schema& schema, CdrReader& reader) {
  if (schema.kind() == Schema::Kind::kDuration) {
    payload::CdrDuration duration;
    if (!payload::ReadDuration(reader, duration)) return std::nullopt;
    return ChannelValue(duration);
  }
  return payload::WithNumber(schema.kind(), [&](auto number) -> std::optional<ChannelValue> {
    if (!reader.Read(number)) return std::nullopt;
    return ChannelValue(number);
  });
}

/// Walks a schema, and a body if there is one, in wire order and lists each number.
class Lister {
 public:
  Lister(const Schema& root, CdrReader* reader) : root_(root), reader_(reader) {}

  /// False if the body cannot be decoded.
  bool Visit(const Schema& schema, const std::string& unit) {
    if (is_full()) return true;
    if (IsChannel(schema)) return VisitNumber(schema, unit);
    if (IsList(schema)) return VisitList(schema, unit);
    if (schema.kind() == Schema::Kind::kString || schema.is_none()) {
      if (position_ && schema.is_none()) {
        ++*position_;
      } else {
        position_.reset();
      }
      return reader_ == nullptr || payload::SkipValues(schema, 1, *reader_);
    }
    for (std::uint32_t i = 0; i < schema.fields().size(); ++i) {
      const Schema::Field& field = schema.fields()[i];
      const bool good = Inside("." + field.name, i, [&] {
        return Visit(field.schema, field.unit.empty() ? unit : field.unit);
      });
      if (!good) return false;
    }
    return true;
  }

  [[nodiscard]] bool is_full() const { return channels_.size() == kMaxChannels; }
  std::vector<PlotChannel> Take() { return std::move(channels_); }

 private:
  bool VisitNumber(const Schema& schema, const std::string& unit) {
    const std::size_t size = schema.minimum_size();
    const bool is_duration = schema.kind() == Schema::Kind::kDuration;
    if (position_) position_ = payload::AlignUp(*position_, is_duration ? 4 : size);
    channels_.push_back({path_, UnitOf(schema, unit), schema, position_, root_, route_});
    if (position_) *position_ += size;
    return reader_ == nullptr || ReadNumber(schema, *reader_);
  }

  bool VisitList(const Schema& list, const std::string& unit) {
    if (list.kind() == Schema::Kind::kSequence) {
      position_.reset();
      if (reader_ == nullptr) return true;
    }
    std::uint32_t count = 0;
    if (reader_ == nullptr) {
      count = list.length();
    } else if (!payload::ReadElementCount(list, *reader_, count)) {
      return false;
    }
    const std::size_t channels_before = channels_.size();
    for (std::uint32_t i = 0; i < count && !is_full(); ++i) {
      const bool good =
          Inside("[" + std::to_string(i) + "]", i, [&] { return Visit(list.element(), unit); });
      if (!good) return false;
      if (reader_ == nullptr && channels_.size() == channels_before) {
        // The elements have no channels. The position stays known only if all elements are None, of
        // one byte each.
        if (position_) *position_ += (count - 1) * list.element().minimum_size();
        break;
      }
    }
    return true;
  }

  template <typename Action>
  bool Inside(const std::string& step, std::uint32_t index, Action action) {
    const std::size_t size = path_.size();
    path_ += step;
    route_.push_back(index);
    const bool good = action();
    route_.pop_back();
    path_.resize(size);
    return good;
  }

  const Schema& root_;
  CdrReader* reader_;
  std::optional<std::size_t> position_ = 0;
  std::string path_;
  std::vector<std::uint32_t> route_;
  std::vector<PlotChannel> channels_;
};

/// Follows a path through a schema, step by step.
class Finder {
 public:
  Finder(const Schema& root, std::string_view path) : rest_(path) {
    channel_.root = root;
    channel_.schema = root;
  }

  Result<PlotChannel> Find() {
    while (!rest_.empty()) {
      const auto step = rest_.front() == '[' ? TakeElement() : TakeField();
      if (!step) return step.error();
    }
    if (!IsChannel(channel_.schema)) {
      return NotFound("'" + channel_.path + "' is " + channel_.schema.TypeName() +
                      ", not one number");
    }
    channel_.unit = UnitOf(channel_.schema, channel_.unit);
    return std::move(channel_);
  }

 private:
  Result<void> TakeField() {
    rest_.remove_prefix(rest_.front() == '.' ? 1 : 0);
    const std::string name(rest_.substr(0, rest_.find_first_of(".[")));
    rest_.remove_prefix(name.size());
    std::vector<std::string> names;
    const auto& fields = channel_.schema.fields();
    for (std::uint32_t i = 0; i < fields.size(); ++i) {
      if (fields[i].name != name) {
        names.push_back(fields[i].name);
        continue;
      }
      channel_.path += "." + name;
      if (!fields[i].unit.empty()) channel_.unit = fields[i].unit;
      Enter(i, Schema(fields[i].schema));
      return {};
    }
    return NotFound(channel_.schema.TypeName() + " has no field '" + name + "'" +
                    DidYouMean(name, names));
  }

  Result<void> TakeElement() {
    std::uint32_t index = 0;
    const char* const end = rest_.data() + rest_.size();
    const auto [last, code] = std::from_chars(rest_.data() + 1, end, index);
    if (code != std::errc{} || last == end || *last != ']') {
      return NotFound("'" + std::string(rest_) + "' does not begin with an index, like [0]");
    }
    rest_ = std::string_view(last + 1, static_cast<std::size_t>(end - last - 1));
    const Schema& list = channel_.schema;
    if (!IsList(list)) return NotFound(list.TypeName() + " has no elements");
    if (list.kind() == Schema::Kind::kArray && index >= list.length()) {
      return NotFound("[" + std::to_string(index) + "] is not in " + list.TypeName());
    }
    channel_.path += "[" + std::to_string(index) + "]";
    Enter(index, Schema(list.element()));
    return {};
  }

  void Enter(std::uint32_t index, Schema schema) {
    channel_.route.push_back(index);
    channel_.schema = std::move(schema);
  }

  static Error NotFound(std::string message) { return {ErrorCode::kNotFound, std::move(message)}; }

  std::string_view rest_;
  PlotChannel channel_;
};

/// Moves the reader to the value at the end of the route.
bool Follow(const PlotChannel& channel, CdrReader& reader) {
  const Schema* schema = &channel.root;
  for (const std::uint32_t index : channel.route) {
    if (IsList(*schema)) {
      std::uint32_t count = 0;
      if (!payload::ReadElementCount(*schema, reader, count) || index >= count) return false;
      schema = &schema->element();
      if (!payload::SkipValues(*schema, index, reader)) return false;
    } else {
      for (std::uint32_t i = 0; i < index; ++i) {
        if (!payload::SkipValues(schema->fields()[i].schema, 1, reader)) return false;
      }
      schema = &schema->fields()[index].schema;
    }
  }
  return true;
}

}  // namespace

std::vector<PlotChannel> Channels(const Schema& schema) {
  Lister lister(schema, nullptr);
  lister.Visit(schema, "");
  return lister.Take();
}

std::vector<PlotChannel> Channels(const Schema& schema, std::span<const std::byte> body) {
  CdrReader reader(body);
  Lister lister(schema, &reader);
  if (!lister.Visit(schema, "") || !(lister.is_full() || reader.AtEnd())) return {};
  return lister.Take();
}

Result<PlotChannel> FindChannel(const Schema& schema, std::string_view path) {
  auto found = Finder(schema, path).Find();
  if (!found) return found;
  for (const PlotChannel& channel : Channels(schema)) {
    if (channel.path == found->path) found->offset = channel.offset;
  }
  return found;
}

std::optional<ChannelValue> ReadExactly(const PlotChannel& channel,
                                        std::span<const std::byte> body) {
  if (channel.offset) {
    if (*channel.offset > body.size()) return std::nullopt;
    CdrReader reader(body.subspan(*channel.offset));
    return ReadNumber(channel.schema, reader);
  }
  CdrReader reader(body);
  if (!Follow(channel, reader)) return std::nullopt;
  return ReadNumber(channel.schema, reader);
}

std::optional<double> ReadChannel(const PlotChannel& channel, std::span<const std::byte> body) {
  const auto value = ReadExactly(channel, body);
  return value ? std::optional(value->real()) : std::nullopt;
}

}  // namespace tendon
