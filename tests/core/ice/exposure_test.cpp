#include <gmock/gmock.h>
#include <tendon/ice/ice_middleware.h>

#include "conformance/recorder.h"
#include "support/log/log_record.h"

namespace tendon::ice {
namespace {

using conformance::Host;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(IceExposure, ListeningInsecurelyIsLogged) {
  const tendon_test::LogRecord log("ice");
  const auto middleware = MakeIceMiddleware(Exposure::kInsecure);
  EXPECT_THAT(log.texts(), IsEmpty());

  Host host;
  const auto listener = middleware->Listen("127.0.0.1:0", host.accept());

  EXPECT_THAT(log.texts(), ElementsAre(HasSubstr("--insecure")));
}

TEST(IceExposure, ListeningLocallyIsNotLogged) {
  const tendon_test::LogRecord log("ice");

  const auto middleware = MakeIceMiddleware(Exposure::kLoopbackOnly);

  EXPECT_THAT(log.texts(), IsEmpty());
}

}  // namespace
}  // namespace tendon::ice
