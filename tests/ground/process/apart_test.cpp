#include "process/apart.h"

#include <gtest/gtest.h>

#include <csignal>

namespace fissure::apart_test {

namespace {

constexpr unsigned long most_s = 10;

InputError comesBack(const InputError& error) {
  try {
    doApart([&] { throw error; }, most_s);
  } catch (const InputError& came) {
    return came;
  }
  return InputError("nothing");
}

TEST(Apart, ErrorsKeepTheirFields) {
  for (const Origin& origin :
       {Origin(), inFile("a b.yaml", 7), ofOverride("tools.0.x"), ofAxis("force.hc.k", "sweep.yaml", 12)}) {
    const InputError back = comesBack({origin, "is wrong, expected: right"});
    EXPECT_EQ(back.origin().kind, origin.kind);
    EXPECT_EQ(back.origin().file, origin.file);
    EXPECT_EQ(back.origin().line, origin.line);
    EXPECT_EQ(back.origin().path, origin.path);
    EXPECT_EQ(back.text(), "is wrong, expected: right");
    EXPECT_EQ(back.what(), origin.beginning() + "is wrong, expected: right");
  }
  EXPECT_STREQ(comesBack(InputError("")).what(), "");
}

TEST(Apart, OtherErrorsAndEndsAreToldApart) {
  EXPECT_NO_THROW(doApart([] {}, most_s));
  try {
    doApart([] { throw std::logic_error("broken"); }, most_s);
    FAIL() << "nothing came back";
  } catch (const RunError& error) {
    EXPECT_STREQ(error.what(), "broken");
  }
  EXPECT_THROW(doApart([] { ::raise(SIGKILL); }, most_s), LostApart);
}

TEST(Apart, AReaderThatFailsIsADamagedFile) {
  try {
    tryReading("a.stl", [] { throw RunError("ends too early"); });
    FAIL() << "nothing came back";
  } catch (const InputError& error) {
    EXPECT_TRUE(error.isAbout("a.stl"));
    EXPECT_EQ(error.text(), "a damaged file (ends too early)");
  }
}

}  // namespace
}  // namespace fissure::apart_test
