#include "core/smartdevice/sample_pieces.h"

#include <gtest/gtest.h>

namespace kickstand::smartdevice {
namespace {

using Part = SamplePieces::Part;

TEST(SamplePieces, WithoutASubscriptionEverythingIsAnAnswer) {
    SamplePieces pieces;
    EXPECT_EQ(pieces.take(0), Part::None);
    EXPECT_EQ(pieces.take(3), Part::None);
}

TEST(SamplePieces, AWholeSampleEndsItself) {
    SamplePieces pieces;
    pieces.restart(0b111, true);
    EXPECT_EQ(pieces.take(0b001), Part::None);
    EXPECT_EQ(pieces.take(0b111), Part::End);
    EXPECT_EQ(pieces.take(0b001), Part::None);
    EXPECT_EQ(pieces.take(0b1000), Part::None) << "it was not asked for";
    EXPECT_EQ(pieces.take(0), Part::None);
}

TEST(SamplePieces, EmptyUpdatesAreSamplesToo) {
    SamplePieces pieces;
    pieces.restart(0, true);
    EXPECT_EQ(pieces.take(0), Part::End);
    EXPECT_EQ(pieces.take(1), Part::None);
}

TEST(SamplePieces, TheCutIsLearntAndAnswersInBetweenAreNone) {
    SamplePieces pieces;
    pieces.restart(0b11111, true);
    EXPECT_EQ(pieces.take(0b00011), Part::None) << "not known yet";
    EXPECT_EQ(pieces.take(0b11100), Part::End);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(pieces.take(0b00011), Part::Piece);
        EXPECT_EQ(pieces.take(0b00001), Part::None);
        EXPECT_EQ(pieces.take(0b11100), Part::End);
        EXPECT_EQ(pieces.take(0b10000), Part::None);
    }
}

TEST(SamplePieces, AnAnswerIsNeverTakenIntoTheCut) {
    SamplePieces pieces;
    pieces.restart(0b1111, true);
    // The first sample comes with an answer in it.
    pieces.take(0b0011);
    pieces.take(0b0001);
    pieces.take(0b1100);
    pieces.take(0b0011);
    pieces.take(0b1100);
    EXPECT_EQ(pieces.take(0b0001), Part::None);
    EXPECT_EQ(pieces.take(0b0011), Part::Piece);
}

TEST(SamplePieces, AnAnswerThatUpsetsTheCutDoesNotMoveItsEnd) {
    SamplePieces pieces;
    pieces.restart(0b1111, true);
    pieces.take(0b0001);
    pieces.take(0b0010);
    pieces.take(0b1100);
    EXPECT_EQ(pieces.take(0b0001), Part::Piece);
    EXPECT_EQ(pieces.take(0b0100), Part::None) << "an answer";
    EXPECT_EQ(pieces.take(0b0010), Part::Piece);
    EXPECT_EQ(pieces.take(0b1100), Part::End);
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(pieces.take(0b0001), Part::Piece);
        EXPECT_EQ(pieces.take(0b0010), Part::Piece);
        EXPECT_EQ(pieces.take(0b1100), Part::End);
    }
}

TEST(SamplePieces, ALostPieceEndsNothing) {
    SamplePieces pieces;
    pieces.restart(0b111, true);
    pieces.take(0b001);
    pieces.take(0b010);
    pieces.take(0b100);
    EXPECT_EQ(pieces.take(0b001), Part::Piece);
    EXPECT_EQ(pieces.take(0b100), Part::Piece);
    EXPECT_EQ(pieces.take(0b001), Part::Piece) << "the next sample has begun";
    EXPECT_EQ(pieces.take(0b010), Part::Piece);
    EXPECT_EQ(pieces.take(0b100), Part::End);
}

TEST(SamplePieces, AnotherSubscriptionIsCutAnew) {
    SamplePieces pieces;
    pieces.restart(0b11, true);
    pieces.take(0b01);
    pieces.take(0b10);
    EXPECT_EQ(pieces.take(0b01), Part::Piece);
    pieces.restart(0b111, true);
    EXPECT_EQ(pieces.take(0b01), Part::None);
}

}  // namespace
}  // namespace kickstand::smartdevice
