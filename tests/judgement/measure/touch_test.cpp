#include "measure/touch.h"

#include <gtest/gtest.h>

#include "mesh/primitives.h"
#include "surface/oracles.h"

namespace fissure::touch_test {

namespace {

using Names = std::vector<std::string>;

/// Two boxes of tissue side by side, a blade above each; contacts as an engine would report them.
class TouchTest : public ::testing::Test {
 protected:
  TouchTest()
      : scene_(test::makeScene({test::moved(makeBox({0.1, 0.1, 0.1}), test::at(-0.1, 0, 0)),
                                test::moved(makeBox({0.1, 0.1, 0.1}), test::at(0.1, 0, 0))},
                               {{0.04, 0.002, 0.015}, {0.04, 0.002, 0.015}})),
        state_(test::restState(scene_, {test::at(-0.1, 0.06, 0), test::at(0.1, 0.06, 0)})),
        meter_(scene_, {0.01}) {
    scene_.tools[0].name = "left";
    scene_.tools[1].name = "right";
    touch_ = std::make_unique<Touch>(scene_);
    state_.contact.vertex_contact.assign(state_.positions_m.size(), 0);
  }
  void step() { touch_->add(state_, meter_, meter_.measure(state_)); }

  Scene scene_;
  State state_;
  PenetrationMeter meter_;
  std::unique_ptr<Touch> touch_;
};

TEST_F(TouchTest, NoToolTouchesAtADistance) {
  step();
  EXPECT_EQ(touch_->steps(), 0);
  EXPECT_EQ(touch_->untouchedTools(), (Names{"left", "right"}));
}

TEST_F(TouchTest, AContactIsTheNearestToolsAndItsVertexsBodys) {
  state_.contact.contact_count = 1;
  const std::size_t second = static_cast<std::size_t>(scene_.bodies[1].first_vertex);
  state_.contact.vertex_contact[second] = 1;
  step();
  EXPECT_EQ(touch_->untouchedTools(), Names{"left"});
  EXPECT_FALSE(touch_->isTouched(0));
  EXPECT_TRUE(touch_->isTouched(1));
  state_.contact.contact_count = 0;
  state_.contact.vertex_contact[second] = 0;
  step();
  EXPECT_EQ(touch_->steps(), 1);
  EXPECT_FALSE(touch_->isTouched(1));
  EXPECT_TRUE(touch_->wasTouched(1));
  EXPECT_FALSE(touch_->wasTouched(0));
}

TEST_F(TouchTest, AToolInTissueTouchesThoughNoContactIsReported) {
  state_.tools[0].pose = test::at(-0.1, 0, 0);
  step();
  EXPECT_EQ(touch_->steps(), 1);
  EXPECT_EQ(touch_->untouchedTools(), Names{"right"});
}

// Without a look at depths, what the engine reports still counts.
TEST_F(TouchTest, AContactBetweenTwoMeasurementsIsSeen) {
  state_.contact.contact_count = 1;
  state_.contact.vertex_contact[0] = 1;
  touch_->addUnmeasured(state_, meter_);
  EXPECT_EQ(touch_->steps(), 1);
  EXPECT_TRUE(touch_->wasTouched(0));
  EXPECT_FALSE(touch_->wasTouched(1));
  EXPECT_EQ(touch_->untouchedTools(), Names{"right"});
}

}  // namespace
}  // namespace fissure::touch_test
