#include "app/kickstand/options.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <cstdio>
#include <cstdlib>

#include "app/composition/composition.h"
#include "core/engine/describe.h"

namespace kickstand::app {

namespace {

constexpr int kBadUsage = 2;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Options)
};

[[noreturn]] void refuse(const QString& what) {
    std::fprintf(stderr, "kickstand: %s\n", qPrintable(what));
    std::exit(kBadUsage);
}

std::optional<ui::ThemeChoice> themeNamed(const QString& name) {
    if (name == u"system") return ui::ThemeChoice::System;
    if (name == u"light") return ui::ThemeChoice::Light;
    if (name == u"dark") return ui::ThemeChoice::Dark;
    return std::nullopt;
}

}  // namespace

Options readOptions(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        Words::tr("A bench for small robots: drive, watch and stop them.\n\n"
                  "Example: kickstand --link sim:thunderbots?robots=0-3"));
    const QCommandLineOption link(
        QStringLiteral("link"),
        Words::tr("Connect to this link at the start; may be given several times. Without "
                  "it the window looks for hardware, and offers simulated robots."),
        QStringLiteral("URI"));
    const QCommandLineOption tour(
        QStringLiteral("tour"),
        Words::tr("Show every panel on simulated robots, do the main jobs, write pictures "
                  "into this folder, and end."),
        QStringLiteral("DIR"));
    const QCommandLineOption announce(
        QStringLiteral("announce"),
        Words::tr("Print \"painted\" when the window has been painted: to measure "
                  "the start."));
    const QCommandLineOption theme(QStringLiteral("theme"), Words::tr("system, light or dark, for this run."),
                                   QStringLiteral("THEME"));
    const QCommandLineOption newInstance(
        QStringLiteral("new-instance"),
        Words::tr("Open another window although one is open. Two windows can drive the same robots."));
    parser.addOptions({link, tour, theme, newInstance, announce});
    const QCommandLineOption help = parser.addHelpOption();
    const QCommandLineOption version = parser.addVersionOption();
    if (!parser.parse(arguments)) refuse(Words::tr("%1. Try --help.").arg(parser.errorText().chopped(1)));
    if (parser.isSet(help)) parser.showHelp(0);
    if (parser.isSet(version)) parser.showVersion();
    if (!parser.positionalArguments().isEmpty()) {
        refuse(Words::tr("\"%1\" is not an option. A link is given with --link; try --help.")
                   .arg(parser.positionalArguments().first()));
    }

    Options options;
    for (const QString& text : parser.values(link)) {
        const Result<LinkUri> uri = parseLinkUri(text.toStdString());
        if (!uri) refuse(describe(uri.error()).line());
        if (const Result<void> taken = checkLink(*uri); !taken) refuse(describe(taken.error()).line());
        options.links.push_back(*uri);
    }
    if (parser.isSet(theme)) {
        options.theme = themeNamed(parser.value(theme));
        if (!options.theme) refuse(Words::tr("--theme takes system, light or dark."));
    }
    if (parser.isSet(tour) && !options.links.empty()) {
        refuse(Words::tr("--tour drives simulated robots alone: leave --link out."));
    }
    options.announce = parser.isSet(announce);
    // A tour and a measurement look at themselves alone.
    options.newInstance = parser.isSet(newInstance) || options.announce || parser.isSet(tour);
    if (parser.isSet(tour)) options.tourFolder = parser.value(tour);
    return options;
}

}  // namespace kickstand::app
