#include <gtest/gtest.h>
TEST(Subdivide, placeholder) {}
