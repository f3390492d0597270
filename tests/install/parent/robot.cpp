#include <tendon/gcm/client.h>
#include <tendon/payload/eigen.h>
#include <tendon/task/periodic_task.h>

int main() { return tendon::ToString(tendon::Status::kDone).empty() ? 1 : 0; }
