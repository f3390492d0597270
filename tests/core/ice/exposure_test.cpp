#include <gmock/gmock.h>
#include <tendon/ice/ice_middleware.h>

#include "support/log/log_record.h"

namespace tendon::ice {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(IceExposure, InsecureIsLoggedAtTheStart) {
  const tendon_test::LogRecord log("ice");

  const auto first = MakeIceMiddleware(Exposure::kInsecure);
  const auto second = MakeIceMiddleware(Exposure::kInsecure);

  EXPECT_THAT(log.texts(), ElementsAre(HasSubstr("--insecure"), HasSubstr("--insecure")));
}

TEST(IceExposure, OfThisMachineAloneIsNotWorthALine) {
  const tendon_test::LogRecord log("ice");

  const auto middleware = MakeIceMiddleware(Exposure::kLoopbackOnly);

  EXPECT_THAT(log.texts(), IsEmpty());
}

}  // namespace
}  // namespace tendon::ice
