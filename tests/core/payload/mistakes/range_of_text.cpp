#include <tendon/payload/payload.h>

struct Note {
  std::string text;
};

template <>
inline constexpr auto tendon::kPayload<Note> =
    tendon::Describe("sample.Note", tendon::Field{"text", &Note::text}.Within(0, 1));

static_assert(tendon::Payload<Note>);
