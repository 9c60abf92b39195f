#pragma once

#include <gmock/gmock.h>

#include <inkedge/error.h>

/// Expects an inkedge::Error of this kind whose text matches.
template <class Function, class Matcher>
void expectError(inkedge::Error::Kind kind, const Matcher& text, Function function) {
    try {
        function();
        ADD_FAILURE() << "expected an error, found none";
    } catch (const inkedge::Error& error) {
        EXPECT_EQ(error.kind(), kind) << error.what();
        EXPECT_THAT(error.what(), text);
        EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("\n"))) << "an error is one line";
    }
}
