#include <tendon/gcm/text/leftover_text.h>

namespace tendon {

bool IsKept(const Diagnosis& diagnosis) {
  constexpr std::size_t kMade = 5;
  const bool is_made = diagnosis.steps.size() > kMade &&
                       diagnosis.steps[kMade].verdict != DiagnosisStep::Verdict::kNotReached;
  return diagnosis.is_connected && diagnosis.failure.has_value() && !is_made;
}

std::vector<std::string> LeftoverTexts(const Diagnosis& diagnosis) {
  if (IsKept(diagnosis)) {
    return {"kept: " + diagnosis.wire.required.process + " makes it as soon as it can"};
  }
  std::vector<std::string> texts;
  for (const Remainder& one : diagnosis.remainders) texts.push_back("left over: " + one.text);
  return texts;
}

}  // namespace tendon
