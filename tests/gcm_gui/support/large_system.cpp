#include "support/large_system.h"

namespace tendon::gui {

std::string LargeProcess(int i) { return "process_" + std::to_string(100 + i); }
std::string LargeComponent(int i) { return "component_" + std::to_string(100 + i); }

SystemBuilder LargeSystem(int processes, int of_each, int commands) {
  const SystemBuilder look = LookSystem(0);
  ComponentDescription model = *look.catalogue().FindComponent("robot", "controller");
  model.required.resize(1);  // keeps only the interface that the arm offers
  model.provided.push_back(look.catalogue().FindComponent("robot", "arm")->provided.front());
  constexpr int kOfAnInterface = 10;
  for (int i = 0; i < commands; ++i) {
    if (i % kOfAnInterface == 0) model.provided.push_back({.name = "Part" + std::to_string(i)});
    model.provided.back().commands.push_back(Void("Command" + std::to_string(i)));
  }
  SystemBuilder system;
  for (int p = 0; p < processes; ++p) {
    system.Process(LargeProcess(p));
    for (int c = 0; c < of_each; ++c) {
      model.name = LargeComponent(c);
      system.Component(LargeProcess(p), model);
      if (c == 0) continue;
      system.Connect({LargeProcess(p), LargeComponent(c), "Arm"},
                     {LargeProcess(p), LargeComponent(c - 1), "Drives"});
    }
  }
  return system;
}

}  // namespace tendon::gui
