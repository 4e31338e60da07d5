#include "core/thunderbots/flash_plan.h"

#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "core/framing/crc16.h"
#include "core/thunderbots/flash_estimate.h"
#include "core/thunderbots/flash_survey.h"

namespace kickstand::thunderbots {
namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr std::size_t kPage = wire::kFlashPageBytes;

FlashPlan planOf(Bytes bytes, image::FlashTarget target = image::FlashTarget::Fpga) {
    image::FlashImage image;
    image.bytes = std::move(bytes);
    image.target = target;
    return FlashPlan(std::move(image));
}

Bytes randomBytes(std::size_t size, unsigned seed = 1) {
    std::mt19937 random(seed);
    Bytes bytes(size);
    std::ranges::generate(bytes, [&random] { return static_cast<std::uint8_t>(random()); });
    return bytes;
}

FlashPage numbered() {
    FlashPage page;
    std::iota(page.begin(), page.end(), std::uint8_t{0});
    return page;
}

/// What the page buffer holds after these messages.
FlashPage filled(FlashPage page, const std::vector<wire::FillPageRequest>& fills) {
    for (const auto& fill : fills)
        std::ranges::copy(fill.data, page.begin() + fill.offset);
    return page;
}

TEST(FlashPlan, LeavesBlankPagesOut) {
    Bytes bytes(5 * kPage, 0xFF);
    bytes[1 * kPage] = 0;
    bytes[3 * kPage + 255] = 0;
    const FlashPlan plan = planOf(bytes);
    EXPECT_EQ(plan.pages(), (std::vector<std::uint16_t>{1, 3}));
    EXPECT_EQ(plan.extent(), 4 * kPage) << "what follows is blank";
}

TEST(FlashPlan, PadsTheLastPage) {
    const FlashPlan plan = planOf(Bytes(kPage + 3, 0x11));
    ASSERT_EQ(plan.pages().size(), 2U);
    const FlashPage last = plan.page(1);
    EXPECT_EQ(last[2], 0x11);
    EXPECT_EQ(last[3], 0xFF);
    EXPECT_EQ(last[255], 0xFF);
    EXPECT_EQ(plan.page(7), FlashPage(plan.page(8))) << "past the end all is blank";
}

TEST(FlashPlan, GivesTheCrcOfAnyPieceOfAFlashThatHoldsTheImage) {
    const Bytes bytes = randomBytes(3 * kPage + 77);
    Bytes flash(wire::kFlashBytes, 0xFF);
    std::ranges::copy(bytes, flash.begin());
    const FlashPlan plan = planOf(bytes);
    for (const FlashRange range : {FlashRange{0, 256}, FlashRange{512, 512}, FlashRange{768, 4096},
                                   FlashRange{65536, 65536}, FlashRange{0, wire::kFlashBytes}})
        EXPECT_EQ(plan.crc(range), crc16(ByteView(flash).subspan(range.address, range.length)));
    EXPECT_EQ(plan.signatures().flash, plan.crc({0, wire::kFlashBytes}));
}

TEST(FlashPlan, NamesItsContents) {
    EXPECT_EQ(planOf(Bytes(9, 1)).contents(), wire::FlashContents::FpgaBitstream);
    EXPECT_EQ(planOf(Bytes(9, 1), image::FlashTarget::Microcontroller).contents(),
              wire::FlashContents::Microcontroller);
}

TEST(CrcBlocks, AreAsLongAsARobotTakesThem) {
    EXPECT_EQ(crcBlocks(0, 0x20100),
              (std::vector<FlashRange>{{0, 0x10000}, {0x10000, 0x10000}, {0x20000, 0x100}}));
    EXPECT_TRUE(crcBlocks(0x100, 0x100).empty());
}

TEST(PlanFills, FillsAWholePageThatNobodyKnows) {
    const auto fills = planFills(std::nullopt, numbered());
    ASSERT_EQ(fills.size(), 5U);
    EXPECT_EQ(fills.back().offset, 4 * wire::kMaxFillBytes);
    FlashPage other;
    other.fill(0x5A);
    EXPECT_EQ(filled(other, fills), numbered());
}

TEST(PlanFills, SendsNothingWhereNothingDiffers) {
    EXPECT_TRUE(planFills(numbered(), numbered()).empty());
}

TEST(PlanFills, SendsOnlyWhatDiffersAndBridgesGapsWithinAMessage) {
    FlashPage wanted = numbered();
    wanted[10] = 99;
    wanted[70] = 99;
    wanted[200] = 99;
    const auto fills = planFills(numbered(), wanted);
    ASSERT_EQ(fills.size(), 2U);
    EXPECT_EQ(fills[0].offset, 10);
    EXPECT_EQ(fills[0].data.size(), 61U);
    EXPECT_EQ(fills[1].offset, 200);
    EXPECT_EQ(fills[1].data.size(), 1U);
}

TEST(PlanFills, ReachesTheLastByteAndNotBeyondIt) {
    FlashPage wanted = numbered();
    wanted[255] = 0;
    const auto fills = planFills(numbered(), wanted);
    ASSERT_EQ(fills.size(), 1U);
    EXPECT_EQ(fills[0].offset, 255);
    EXPECT_EQ(fills[0].data.size(), 1U);
}

/// The fewest messages there can be, tried out: for each first byte, all lengths.
int fewest(const FlashPage& from, const FlashPage& to) {
    std::vector<int> needed(kPage + 1, 0);
    for (std::size_t at = kPage; at-- > 0;) {
        needed[at] = from[at] == to[at] ? needed[at + 1] : 1000;
        for (std::size_t length = 1; length <= wire::kMaxFillBytes && at + length <= kPage; ++length)
            needed[at] = std::min(needed[at], 1 + needed[at + length]);
    }
    return needed[0];
}

TEST(PlanFills, MakesAnyPageOfAnyOtherWithTheFewestMessages) {
    std::mt19937 random(7);
    for (int round = 0; round < 300; ++round) {
        const FlashPage from = numbered();
        FlashPage to = from;
        for (auto changes = random() % 12; changes > 0; --changes) {
            const auto at = random() % kPage;
            const auto length = std::min<std::size_t>(random() % 40 + 1, kPage - at);
            for (std::size_t i = at; i < at + length; ++i)
                to[i] = static_cast<std::uint8_t>(random());
        }
        const auto fills = planFills(from, to);
        ASSERT_EQ(filled(from, fills), to);
        ASSERT_EQ(fills.size(), static_cast<std::size_t>(fewest(from, to)));
        for (const auto& fill : fills)
            ASSERT_TRUE(wire::encodeFirmwareRequest(fill)) << "a message that the wire takes";
    }
}

/// A robot that answers a survey from its flash.
class Surveyed {
  public:
    explicit Surveyed(const FlashPlan& plan, std::uint32_t end = wire::kFlashBytes) : survey(plan, end) {
        std::ranges::fill(flash, std::uint8_t{0xFF});
    }
    void write(const FlashPlan& plan, std::size_t page) {
        std::ranges::copy(plan.page(static_cast<std::uint16_t>(page)),
                          flash.begin() + static_cast<std::ptrdiff_t>(page * kPage));
    }
    void run() {
        while (const auto range = survey.next()) {
            ASSERT_LE(range->length, wire::kMaxCrcBlock);
            ASSERT_LT(++asked, 2000);
            survey.answered(crc16(ByteView(flash).subspan(range->address, range->length)));
        }
    }
    Bytes flash = Bytes(wire::kFlashBytes);
    FlashSurvey survey;
    int asked = 0;
};

TEST(FlashSurvey, FindsAllPagesMissingInABlankFlash) {
    const FlashPlan plan = planOf(randomBytes(300 * kPage));
    Surveyed robot(plan);
    robot.run();
    EXPECT_EQ(robot.survey.missing(), plan.pages());
    EXPECT_FALSE(robot.survey.dirtyAt());
    EXPECT_EQ(robot.asked, 33) << "a CRC for each of the largest blocks, and one where the image ends";
    EXPECT_EQ(robot.survey.known_B(), wire::kFlashBytes);
}

TEST(FlashSurvey, FindsNothingMissingWhereAllIsThere) {
    const FlashPlan plan = planOf(randomBytes(20 * kPage));
    Surveyed robot(plan);
    for (std::size_t page = 0; page < 20; ++page)
        robot.write(plan, page);
    robot.run();
    EXPECT_TRUE(robot.survey.missing().empty());
    EXPECT_FALSE(robot.survey.dirtyAt());
}

TEST(FlashSurvey, FindsWherePagesAreMissing) {
    const FlashPlan plan = planOf(randomBytes(600 * kPage));
    Surveyed robot(plan);
    for (std::size_t page = 0; page < 600; ++page) {
        if (page != 3 && page < 411) robot.write(plan, page);
    }
    robot.run();
    std::vector<std::uint16_t> missing{3};
    for (std::uint16_t page = 411; page < 600; ++page)
        missing.push_back(page);
    EXPECT_EQ(robot.survey.missing(), missing);
    EXPECT_LE(robot.asked, 33 + 2 * 2 * 8) << "two of the largest blocks, halved eight times";
}

TEST(FlashSurvey, NamesThePageThatHoldsSomethingElse) {
    const FlashPlan plan = planOf(randomBytes(600 * kPage));
    Surveyed robot(plan);
    for (std::size_t page = 0; page < 600; ++page)
        robot.write(plan, page);
    robot.flash[517 * kPage + 9] ^= 1;
    robot.run();
    EXPECT_EQ(robot.survey.dirtyAt(), 517 * kPage);
}

TEST(FlashSurvey, NamesWhatStandsBehindTheImage) {
    const FlashPlan plan = planOf(randomBytes(10 * kPage));
    Surveyed robot(plan);
    robot.flash[0x180000] = 0;
    robot.run();
    ASSERT_TRUE(robot.survey.dirtyAt());
    EXPECT_LE(*robot.survey.dirtyAt(), 0x180000U);
    EXPECT_GT(*robot.survey.dirtyAt() + wire::kMaxCrcBlock, 0x180000U);
}

TEST(FlashSurvey, LooksNoFurtherThanItIsTold) {
    const FlashPlan plan = planOf(randomBytes(10 * kPage));
    Surveyed robot(plan, plan.extent());
    robot.flash[0x180000] = 0;
    robot.run();
    EXPECT_FALSE(robot.survey.dirtyAt());
    EXPECT_EQ(robot.asked, 1);
}

TEST(FlashEstimate, CountsWhatIsStillToBeDone) {
    using namespace std::chrono_literals;
    const std::vector plans{std::make_shared<const FlashPlan>(planOf(randomBytes(1000 * kPage)))};
    FlashProgress progress;
    const auto left_s = [&](Duration inStage) {
        return seconds(estimateRemaining(plans, progress, inStage));
    };
    const double whole_s = left_s(0s);
    EXPECT_NEAR(whole_s, 8 + 9 + 0.26 + 4 + 2.1, 0.1);
    progress.stage = FlashStage::Erasing;
    EXPECT_NEAR(left_s(3s), whole_s - 3, 0.01);
    EXPECT_NEAR(left_s(20s), whole_s - 8, 0.01) << "never less than nothing";
    progress.stage = FlashStage::Writing;
    progress.total_B = 1000 * kPage;
    progress.done_B = 500 * kPage;
    EXPECT_NEAR(left_s(10s), 10 + 0.26 + 4 + 2.1, 0.1) << "at the pace of the pages before";
    progress.stage = FlashStage::Done;
    EXPECT_EQ(left_s(0s), 0);
}

}  // namespace
}  // namespace kickstand::thunderbots
