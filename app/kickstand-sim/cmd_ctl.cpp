#include <QFile>
#include <array>

#include "app/kickstand-sim/control_client.h"
#include "app/kickstand-sim/control_desk.h"
#include "app/kickstand-sim/control_path.h"
#include "app/kickstand-sim/ctl_text.h"
#include "app/kickstand-sim/ctl_words.h"
#include "app/kickstand-sim/families.h"
#include "app/kickstand-sim/json.h"
#include "app/kickstand-sim/words.h"
#include "app/kickstandctl/interruption.h"
#include "app/kickstandctl/save_file.h"
#include "core/engine/describe_facts.h"

namespace kickstand::sim {
namespace {

constexpr std::size_t kMaxWords = 3;

/// One ctl command, with the simulator that it is for.
class Ctl {
  public:
    Ctl(ctl::Output& output, ctl::Interruption& interruption, std::span<const std::string> words)
        : output_(output), words_(words), client_(interruption) {}

    ctl::Outcome run(const std::string& path) {
        if (auto connected = client_.connect(path); !connected) return connected;
        auto actions = client_.ask({{QStringLiteral("request"), QStringLiteral("actions")}});
        if (!actions) return tl::unexpected(actions.error());
        actions_ = std::move(*actions);
        unitName_ = actions_[QStringLiteral("of")].toString();
        const std::string& what = words_.front();
        if (what == "actions") return listActions();
        if (what == "show") return show();
        if (what == "flash") return saveFlash();
        return perform();
    }

  private:
    ctl::Outcome wrongForm(const QString& form) const {
        return ctl::badUsage(Words::tr("“%1” has another form.").arg(printable(words_.front())),
                             Words::tr("It is: kickstand-sim ctl %1.").arg(form));
    }

    void value(QJsonObject json) {
        json.remove(QStringLiteral("ok"));
        output_.value(json);
    }

    ctl::Outcome listActions() {
        if (words_.size() != 1) return wrongForm(QStringLiteral("actions"));
        value(actions_);
        printActions(output_, actions_);
        return {};
    }

    ctl::Outcome perform() {
        const auto request = actionRequest(words_, actions_);
        if (!request) return tl::unexpected(request.error());
        const auto answer = client_.ask(*request);
        if (!answer) return tl::unexpected(answer.error());
        value(*answer);
        printDone(output_, *answer, unitName_);
        return {};
    }

    ctl::Outcome show() {
        if (words_.size() > 2) return wrongForm(QStringLiteral("show [%1]").arg(unitName_.toUpper()));
        QJsonObject request{{QStringLiteral("request"), QStringLiteral("show")}};
        if (words_.size() == 2) {
            const auto unit = readUnit(words_[1], unitName_, false);
            if (!unit) return tl::unexpected(unit.error());
            request[unitName_] = *unit;
        }
        const auto answer = client_.ask(request);
        if (!answer) return tl::unexpected(answer.error());
        value(*answer);
        if (answer->value(QStringLiteral("system")).toString() == QLatin1String("thunderbots"))
            printThunderbots(output_, *answer, words_.size() == 2);
        else
            output_.line(QString::fromUtf8(compact(*answer)));
        return {};
    }

    ctl::Outcome saveFlash() {
        if (words_.size() != 3) return wrongForm(QStringLiteral("flash %1 FILE").arg(unitName_.toUpper()));
        const auto unit = readUnit(words_[1], unitName_, false);
        if (!unit) return tl::unexpected(unit.error());
        const auto image = readFlash(*unit);
        if (!image) return tl::unexpected(image.error());
        if (auto saved = ctl::saveFile(QFile::decodeName(words_[2].c_str()), *image); !saved) return saved;
        value({{unitName_, *unit},
               {QStringLiteral("bytes"), image->size()},
               {QStringLiteral("file"), printable(words_[2])}});
        output_.line(Words::tr("%1 bytes written to %2").arg(image->size()).arg(printable(words_[2])));
        return {};
    }

    ctl::Expected<QByteArray> readFlash(const QJsonValue& unit) {
        QByteArray image;
        qint64 all = 1;
        while (image.size() < all) {
            // The first piece says how many there are.
            const qint64 length = image.isEmpty() ? 1 : std::min<qint64>(kMaxFlashPiece, all - image.size());
            const auto answer = client_.ask({{QStringLiteral("request"), QStringLiteral("flash")},
                                             {unitName_, unit},
                                             {QStringLiteral("address"), image.size()},
                                             {QStringLiteral("length"), length}});
            if (!answer) return tl::unexpected(answer.error());
            const auto piece =
                QByteArray::fromBase64(answer->value(QStringLiteral("base64")).toString().toLatin1());
            if (piece.size() != length) return ctl::failed({.code = Errc::Malformed, .subject = "flash"});
            image += piece;
            all = answer->value(QStringLiteral("flash_bytes")).toInteger();
        }
        return image;
    }

    ctl::Output& output_;
    const std::span<const std::string> words_;
    ControlClient client_;
    QJsonObject actions_;
    QString unitName_;
};

ctl::Outcome run(const Invocation& invocation) {
    if (invocation.operands.empty())
        return ctl::badUsage(Words::tr("Nothing was asked for."),
                             Words::tr("kickstand-sim ctl actions lists what there is to do."));
    const std::string path =
        invocation.has("--control") ? std::string(invocation.text("--control")) : defaultControlPath().path;
    ctl::Interruption interruption;
    ctl::Output output(invocation.has("--json"), interruption);
    ctl::Outcome outcome = Ctl(output, interruption, invocation.operands).run(path);
    if (!outcome && !output.hasValue()) {
        QJsonObject json = toJson(outcome.error());
        json.remove(QStringLiteral("ok"));
        output.value(json);
    }
    if (outcome && output.failed()) {
        outcome = ctl::failed({.code = Errc::Io});
        outcome.error().text = {
            Words::tr("Not everything could be written."), Words::tr("Check where the output goes."), {}};
    }
    return outcome;
}

constexpr std::array kOptions{
    OptionSpec{
        "--control", "PATH",
        QT_TRANSLATE_NOOP("kickstand_sim", "the simulator's control socket, where it is not the usual one")},
    OptionSpec{"--json", "", QT_TRANSLATE_NOOP("kickstand_sim", "one JSON value")},
};

}  // namespace

CommandSpec ctlCommand() {
    return {
        "ctl",
        QT_TRANSLATE_NOOP("kickstand_sim",
                          "actions | show [ROBOT] | ACTION [ROBOT|all] [VALUE] | flash ROBOT FILE"),
        kMaxWords,
        QT_TRANSLATE_NOOP("kickstand_sim",
                          "Tells a running simulator what to do, and shows what its robots received."),
        QT_TRANSLATE_NOOP(
            "kickstand_sim",
            "Put a ball into robot 3's beam: ball 3 1. Drain a battery: battery 3 14.2. Switch a robot off\n"
            "and on: kill 3, revive 3. And: e-stop stop, radio-failure 0, loss 0.1, stall 0x85, unplug,\n"
            "replug. “actions” lists them all, with their bounds; “flash” saves a robot's flash memory."),
        kOptions,
        "ctl ball 3 1",
        run};
}

}  // namespace kickstand::sim
