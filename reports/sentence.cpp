#include "reports/sentence.h"

#include "reports/text.h"

namespace plumb::doc {
namespace {

struct Mark {
    Style style;
    std::string_view open, close;
    const char* element;
    const char* plain;  // Stands before its text where there is no style.
};

constexpr Mark kMarks[] = {{Style::kCode, "`", "`", "code", ""},
                           {Style::kStress, "*", "*", "em", ""},
                           {Style::kLow, "_{", "}", "sub", "_"},
                           {Style::kHigh, "^{", "}", "sup", "^"}};

const Mark* MarkOf(Style style) {
    for (const Mark& mark : kMarks) {
        if (mark.style == style) return &mark;
    }
    return nullptr;
}

}  // namespace

std::vector<Span> SpansOf(std::string_view sentence) {
    std::vector<Span> spans;
    std::string plain;
    const auto end_plain = [&] {
        if (!plain.empty()) spans.push_back({Style::kPlain, plain});
        plain.clear();
    };
    while (!sentence.empty()) {
        if (sentence.front() == '\\' && sentence.size() > 1) {
            plain += sentence[1];
            sentence.remove_prefix(2);
            continue;
        }
        bool marked = false;
        for (const Mark& mark : kMarks) {
            if (!sentence.starts_with(mark.open)) continue;
            std::size_t at = mark.open.size();
            std::string text;
            while (at < sentence.size() && !sentence.substr(at).starts_with(mark.close)) {
                at += sentence[at] == '\\' && at + 1 < sentence.size();
                text += sentence[at++];
            }
            if (at >= sentence.size() || text.empty()) continue;
            end_plain();
            spans.push_back({mark.style, text});
            sentence.remove_prefix(at + mark.close.size());
            marked = true;
            break;
        }
        if (marked) continue;
        plain += sentence.front();
        sentence.remove_prefix(1);
    }
    end_plain();
    return spans;
}

std::string PlainText(std::string_view sentence) {
    std::string text;
    for (const Span& span : SpansOf(sentence)) {
        if (const Mark* mark = MarkOf(span.style)) text += mark->plain;
        text += span.text;
    }
    return text;
}

bool IsCode(std::string_view sentence) {
    const std::vector<Span> spans = SpansOf(sentence);
    return spans.size() == 1 && spans[0].style == Style::kCode;
}

std::string SentenceHtml(std::string_view sentence) {
    std::string html;
    for (const Span& span : SpansOf(sentence)) {
        const Mark* mark = MarkOf(span.style);
        if (mark == nullptr) {
            html += Html(span.text);
            continue;
        }
        const std::string element = mark->element;
        html += "<" + element + ">" + Html(span.text) + "</" + element + ">";
    }
    return html;
}

}  // namespace plumb::doc
