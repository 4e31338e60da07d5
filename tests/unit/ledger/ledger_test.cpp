#include "core/ledger/ledger.h"

#include <cstring>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/unit/ledger/ledger_files.h"

namespace kickstand {
namespace {

using std::chrono::seconds;
using testing::recordOf;
using testing::TemporaryFolder;

/// A watchdog, not a measure.
constexpr Duration kLong = seconds(30);

/// Another program that holds a database: the bytes that SQLite locks, locked by a process of their own.
class OtherProgram {
  public:
    explicit OtherProgram(const std::string& file) {
        int ready[2];
        int go[2];
        EXPECT_EQ(pipe(ready), 0);
        EXPECT_EQ(pipe(go), 0);
        child_ = fork();
        if (child_ == 0) {
            close(go[1]);
            struct flock lock;
            std::memset(&lock, 0, sizeof lock);
            lock.l_type = F_WRLCK;
            lock.l_whence = SEEK_SET;
            lock.l_start = 0x40000000;
            lock.l_len = 512;
            char byte = fcntl(open(file.c_str(), O_RDWR), F_SETLK, &lock) == 0 ? '1' : '0';
            static_cast<void>(!write(ready[1], &byte, 1));
            // Ends when the other side closes its end, or is gone.
            static_cast<void>(!read(go[0], &byte, 1));
            _exit(0);
        }
        close(ready[1]);
        close(go[0]);
        hold_ = go[1];
        char byte = '0';
        EXPECT_EQ(read(ready[0], &byte, 1), 1);
        EXPECT_EQ(byte, '1');
        close(ready[0]);
    }
    ~OtherProgram() { letGo(); }
    OtherProgram(const OtherProgram&) = delete;
    OtherProgram& operator=(const OtherProgram&) = delete;

    void letGo() {
        if (hold_ < 0) return;
        close(hold_);
        hold_ = -1;
        waitpid(child_, nullptr, 0);
    }

  private:
    pid_t child_ = -1;
    int hold_ = -1;
};

/// Waits until the ledger has an error, or has got rid of it.
bool awaitError(const Ledger& ledger, bool wanted) {
    const auto end = std::chrono::steady_clock::now() + kLong;
    while (ledger.view().error.has_value() != wanted) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::yield();
    }
    return true;
}

TEST(Ledger, KeepsWhatItIsGivenAndShowsItNewestFirst) {
    Ledger ledger(":memory:");
    EXPECT_TRUE(ledger.add(recordOf(3)));
    EXPECT_TRUE(ledger.add(recordOf(5)));
    EXPECT_TRUE(ledger.add(SignatureRecord{"usb:", 3, 1, 2}));
    EXPECT_TRUE(ledger.setNote(2, "new wheels"));
    ASSERT_TRUE(ledger.flush(kLong));
    const LedgerView view = ledger.view();
    ASSERT_EQ(view.records->size(), 2U);
    EXPECT_EQ(view.records->at(0).robot, 5);
    EXPECT_EQ(view.records->at(0).note, "new wheels");
    EXPECT_EQ(view.records->at(1).microcontrollerSignature, 1);
    EXPECT_FALSE(view.error.has_value());
    EXPECT_EQ(view.lost, 0U);
    EXPECT_TRUE(view.opened);
}

TEST(Ledger, WritesWhatWaitsBeforeItEnds) {
    const TemporaryFolder folder;
    {
        Ledger ledger(folder.path("fleet.sqlite"));
        for (int robot = 0; robot < 16; ++robot)
            ledger.add(recordOf(robot));
    }
    Ledger ledger(folder.path("fleet.sqlite"));
    ASSERT_TRUE(ledger.flush(kLong));
    EXPECT_EQ(ledger.view().records->size(), 16U);
}

TEST(Ledger, TwoOfThemShareAFile) {
    const TemporaryFolder folder;
    Ledger one(folder.path("fleet.sqlite"));
    Ledger other(folder.path("fleet.sqlite"));
    for (int i = 0; i < 20; ++i) {
        one.add(recordOf(1));
        other.add(recordOf(2));
    }
    ASSERT_TRUE(one.flush(kLong));
    ASSERT_TRUE(other.flush(kLong));
    one.setNote(1, "seen");
    ASSERT_TRUE(one.flush(kLong));
    EXPECT_EQ(one.view().records->size(), 40U);
    EXPECT_EQ(one.view().lost + other.view().lost, 0U);
}

TEST(Ledger, AFileThatAnotherProgramHoldsIsTriedAgain) {
    const TemporaryFolder folder;
    const std::string file = folder.copyOf("good.sqlite");
    OtherProgram holder(file);
    Ledger ledger(file);
    EXPECT_TRUE(ledger.add(recordOf(9)));
    ASSERT_TRUE(awaitError(ledger, true));
    EXPECT_EQ(ledger.view().error->code, Errc::TimedOut);
    EXPECT_FALSE(ledger.flush(Duration::zero()));
    EXPECT_EQ(ledger.view().lost, 0U);
    holder.letGo();
    ASSERT_TRUE(awaitError(ledger, false));
    ASSERT_TRUE(ledger.flush(kLong));
    EXPECT_EQ(ledger.view().records->front().robot, 9);
}

TEST(Ledger, AFileThatIsNoLedgerLosesWhatItIsGivenAndSaysSo) {
    const TemporaryFolder folder;
    Ledger ledger(folder.copyOf("no-database.sqlite"));
    ledger.add(recordOf(3));
    ASSERT_TRUE(ledger.flush(kLong));
    ASSERT_TRUE(ledger.view().error.has_value());
    EXPECT_EQ(ledger.view().error->code, Errc::Malformed);
    EXPECT_EQ(ledger.view().lost, 1U);
    EXPECT_TRUE(ledger.view().records->empty());
}

TEST(Ledger, NeverHoldsMoreThanItHasRoomFor) {
    const TemporaryFolder folder;
    const std::string file = folder.copyOf("good.sqlite");
    const OtherProgram holder(file);
    Ledger ledger(file);
    for (std::size_t i = 0; i < Ledger::kCapacity; ++i)
        EXPECT_TRUE(ledger.add(recordOf(1)));
    const std::uint64_t before = ledger.view().version;
    EXPECT_FALSE(ledger.add(recordOf(1)));
    EXPECT_EQ(ledger.view().lost, 1U);
    EXPECT_GT(ledger.view().version, before);
}

TEST(Ledger, ALongNoteIsCutBetweenCharacters) {
    Ledger ledger(":memory:");
    ledger.add(recordOf(1));
    std::string note(Ledger::kLongestNote - 1, 'a');
    ledger.setNote(1, note + "ü and more");
    ASSERT_TRUE(ledger.flush(kLong));
    EXPECT_EQ(ledger.view().records->front().note, note);
}

}  // namespace
}  // namespace kickstand
