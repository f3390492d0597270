#include <tendon/payload/robot/geometry.h>
#include <tendon/payload/robot/image.h>
#include <tendon/payload/robot/joints.h>
#include <tendon/payload/robot/joystick.h>
#include <tendon/payload/robot/transforms.h>
#include <tendon/process/process.h>
#include <tendon/task/thread_options.h>

// Each structure names only some of its members, as an author's code does.

namespace robot = tendon::robot;

inline const robot::Header kHeader{.stamp = {}};
inline const robot::Pose kPose{.position = {.x = 1.0}};
inline const robot::Transform kTransform{.translation = {.z = 1.0}};
inline const robot::Twist kTwist{.linear = {.y = 1.0}};
inline const robot::Wrench kWrench{.force = {.x = 1.0}};
inline const robot::NamedJointState kJoints{.name = {"elbow"}};
inline const robot::Joystick kJoystick{.axes = {0.5F}};
inline const robot::Image kImage{.header = {.stamp = {}}};
inline const robot::TransformStamped kStamped{.header = {.stamp = {}}};
inline const tendon::ProcessOptions kProcess{.gcm = "localhost"};
inline const tendon::ThreadOptions kThread{.priority = 50};
