#include "core/ledger/ledger.h"

#include <utility>

#include "core/ledger/ledger_store.h"

namespace kickstand {
namespace {

/// How long to wait before a file that another program holds is tried again.
constexpr auto kTryAgain = std::chrono::milliseconds(500);

/// The start of a text of UTF-8, with no character cut in two.
void cut(std::string& text, std::size_t most) {
    if (text.size() <= most) return;
    while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80)
        --most;
    text.resize(most);
}

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

}  // namespace

class Ledger::Store : public LedgerStore {
  public:
    Result<void> write(const Change& change) {
        return std::visit(Overloaded{[this](const Note& note) { return setNote(note.id, note.text); },
                                     [this](const auto& record) { return add(record); }},
                          change);
    }
};

Ledger::Ledger(std::string file) {
    thread_ = std::thread([this, file = std::move(file)] { run(file); });
}

Ledger::~Ledger() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    wake_.notify_all();
    thread_.join();
}

bool Ledger::add(ParameterRecord record) {
    cut(record.note, kLongestNote);
    return push(std::move(record));
}

bool Ledger::add(const SignatureRecord& signatures) {
    return push(signatures);
}

bool Ledger::setNote(std::int64_t id, std::string note) {
    cut(note, kLongestNote);
    return push(Note{id, std::move(note)});
}

bool Ledger::push(Change change) {
    {
        const std::lock_guard lock(mutex_);
        if (changes_.size() >= kCapacity) {
            ++view_.lost;
            ++view_.version;
            return false;
        }
        changes_.push_back(std::move(change));
    }
    wake_.notify_all();
    return true;
}

LedgerView Ledger::view() const {
    const std::lock_guard lock(mutex_);
    return view_;
}

bool Ledger::flush(Duration limit) {
    std::unique_lock lock(mutex_);
    return idle_.wait_for(lock, limit, [this] { return changes_.empty() && idling_; });
}

void Ledger::setError(std::optional<Error> error) {
    if (view_.error == error) return;
    view_.error = std::move(error);
    ++view_.version;
}

void Ledger::run(const std::string& file) {
    Store store;
    std::unique_lock lock(mutex_);
    for (;;) {
        const bool done = work(store, file, lock);
        if (done && !changes_.empty()) continue;
        if (ending_) return;
        if (!done) {
            wake_.wait_for(lock, kTryAgain, [this] { return ending_; });
            continue;
        }
        idling_ = true;
        idle_.notify_all();
        wake_.wait(lock, [this] { return ending_ || !changes_.empty(); });
        idling_ = false;
    }
}

bool Ledger::openFile(Store& store, const std::string& file, std::unique_lock<std::mutex>& lock) {
    lock.unlock();
    auto opened = store.open(file);
    lock.lock();
    view_.opened = true;
    ++view_.version;
    if (opened) {
        setError(std::nullopt);
        readNewest(store, lock);
        return true;
    }
    const bool later = opened.error().code == Errc::TimedOut;
    setError(std::move(opened.error()));
    if (later) return false;
    view_.lost += changes_.size();
    changes_.clear();
    return true;
}

bool Ledger::work(Store& store, const std::string& file, std::unique_lock<std::mutex>& lock) {
    if (!store.isOpen() && !openFile(store, file, lock)) return false;
    while (!changes_.empty()) {
        // A copy: once the lock is open, others put changes behind it.
        const Change change = changes_.front();
        lock.unlock();
        auto written = store.write(change);
        lock.lock();
        const bool later = !written && written.error().code == Errc::TimedOut;
        if (!written) setError(std::move(written.error()));
        if (later) return false;
        changes_.pop_front();
        if (written) {
            setError(std::nullopt);
        } else {
            ++view_.lost;
            ++view_.version;
        }
        if (changes_.empty()) readNewest(store, lock);
    }
    return true;
}

void Ledger::readNewest(Store& store, std::unique_lock<std::mutex>& lock) {
    lock.unlock();
    auto listing = store.newest(kMostShown);
    lock.lock();
    if (!listing) {
        setError(std::move(listing.error()));
        return;
    }
    view_.records = std::make_shared<const std::vector<ParameterRecord>>(std::move(listing->records));
    view_.unreadable = listing->unreadable;
    ++view_.version;
}

}  // namespace kickstand
