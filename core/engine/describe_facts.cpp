#include "core/engine/describe_facts.h"

namespace kickstand {
namespace {

constexpr qsizetype kLongest = 400;

bool breaksALine(QChar c) {
    switch (c.category()) {
        case QChar::Other_Control:
        case QChar::Other_Format:
        case QChar::Separator_Line:
        case QChar::Separator_Paragraph:
            return true;
        default:
            return false;
    }
}

std::optional<QString> text(const std::string& fact) {
    if (fact.empty()) return std::nullopt;
    return printable(fact);
}

template <class Number>
std::optional<QString> text(const std::optional<Number>& fact, Number add = 0) {
    if (!fact) return std::nullopt;
    return QString::number(*fact + add);
}

std::optional<QString> factOf(const Error& error, QStringView name) {
    if (name == u"subject") return text(error.subject);
    if (name == u"detail") return text(error.detail);
    if (name == u"port") return text(error.port);
    if (name == u"robot") return text(error.robot);
    if (name == u"lowest") return text(error.lowest);
    if (name == u"highest") return text(error.highest);
    if (name == u"got") return text(error.got);
    if (name == u"place") return text(error.got, std::int64_t{1});
    if (name == u"endpoint" && error.endpoint)
        return QStringLiteral("0x%1").arg(*error.endpoint, 2, 16, QLatin1Char('0'));
    return std::nullopt;
}

/// A piece without brackets.
std::optional<QString> fillPiece(QStringView piece, const Error& error) {
    QString filled;
    while (!piece.isEmpty()) {
        const qsizetype open = piece.indexOf(u'{');
        const qsizetype close = open < 0 ? -1 : piece.indexOf(u'}', open);
        if (close < 0) return filled.append(piece);
        const auto fact = factOf(error, piece.mid(open + 1, close - open - 1));
        if (!fact) return std::nullopt;
        filled += piece.left(open);
        filled += *fact;
        piece = piece.mid(close + 1);
    }
    return filled;
}

}  // namespace

QString printable(const std::string& text) {
    QString shown = QString::fromStdString(text);
    if (shown.size() > kLongest) {
        shown.truncate(kLongest);
        shown += QChar(0x2026);
    }
    for (QChar& c : shown) {
        // A tab is harmless but would upset columns.
        if (c == u'\t')
            c = u' ';
        else if (breaksALine(c))
            c = QChar::ReplacementCharacter;
    }
    return shown.trimmed();
}

std::optional<QString> fillFacts(const QString& text, const Error& error) {
    QString filled;
    QStringView rest(text);
    while (!rest.isEmpty()) {
        const qsizetype open = rest.indexOf(u'[');
        const qsizetype close = open < 0 ? -1 : rest.indexOf(u']', open);
        const auto always = fillPiece(close < 0 ? rest : rest.left(open), error);
        if (!always) return std::nullopt;
        filled += *always;
        if (close < 0) break;
        if (const auto perhaps = fillPiece(rest.mid(open + 1, close - open - 1), error)) filled += *perhaps;
        rest = rest.mid(close + 1);
    }
    return filled;
}

}  // namespace kickstand
