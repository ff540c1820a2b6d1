#include "tools/batch/contact_sheet.h"

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/text.h"
#include "tools/address.h"
#include "tools/batch/outcome.h"

namespace toile {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Batch</title>
<style>
body { font: 14px/1.4 sans-serif; margin: 1.5em; color: #222; background: #f4f3f1; }
h1 { font-size: 1.3em; margin: 0 0 .6em; }
nav { position: sticky; top: 0; padding: .6em 0; background: #f4f3f1; }
button, input { font: inherit; padding: .25em .8em; margin: 0 .3em .3em 0; border: 1px solid #aaa;
  border-radius: 1em; background: white; }
button { cursor: pointer; }
button[aria-pressed=true] { background: #333; color: white; }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(300px, 1fr)); gap: 1em; }
article { background: white; border-left: 5px solid #b5541c; padding: .6em; overflow-wrap: anywhere; }
article.sewn { border-color: #3a7d44; }
article.too_tight { border-color: #c9a227; }
article.error { border-color: #8a1c1c; }
article[hidden] { display: none; }
h2 { font-size: 1em; margin: 0; }
p { margin: .2em 0; }
.pictures { display: flex; }
.pictures a { width: 50%; }
.pictures img { width: 100%; height: 320px; object-fit: contain; }
.small { color: #666; font-size: .9em; max-height: 5.6em; overflow: auto; }
</style>
</head>
<body>
)";

constexpr const char* script = R"(<script>
const cards = [...document.querySelectorAll("article")];
const buttons = [...document.querySelectorAll("button")];
const search = document.querySelector("input");
let verdict = "";
function show() {
  const words = search.value.toLowerCase();
  for (const card of cards) {
    card.hidden = (verdict && card.className !== verdict) ||
        !card.textContent.toLowerCase().includes(words);
  }
  for (const button of buttons) button.setAttribute("aria-pressed", button.dataset.verdict === verdict);
}
for (const button of buttons) {
  button.addEventListener("click", () => { verdict = button.dataset.verdict; show(); });
}
search.addEventListener("input", show);
show();
</script>
</body>
</html>
)";

std::string link(const std::string& folder, const std::string& file, const std::string& words) {
  return "<a href=\"" + page_address(std::filesystem::path(folder) / file) + "\">" + words + "</a>";
}

std::string picture(const std::string& folder, const std::string& side) {
  return link(folder, side + ".png",
              "<img loading=\"lazy\" src=\"" +
                  page_address(std::filesystem::path(folder) / (side + ".png")) + "\" alt=\"" +
                  side + "\">");
}

void add_card(std::ostream& page, const Json& report) {
  const auto name = report["name"].get<std::string>();
  const auto verdict = report["verdict"].get<std::string>();
  const auto line = [&](const std::string& text, const char* kind) {
    if (!text.empty()) page << "<p" << kind << ">" << html_escaped(text) << "</p>\n";
  };
  page << "<article class=\"" << html_escaped(verdict) << "\">\n<h2>" << html_escaped(name)
       << "</h2>\n";
  const bool is_error = verdict == error_verdict;
  const bool has_pictures = !is_error && report["outputs"].contains("front.png");
  if (has_pictures) {
    page << "<div class=\"pictures\">" << picture(name, "front") << picture(name, "back")
         << "</div>\n";
  }
  page << "<p><b>" << html_escaped(verdict) << "</b> "
       << html_escaped(report["cause"].get<std::string>()) << "</p>\n";
  line(report["detail"].get<std::string>(), "");
  for (const Json& warning : report["warnings"]) {
    line("warning: " + warning["text"].get<std::string>(), " class=\"small\"");
  }
  std::string girths;
  std::string figures = fixed_number(report["seconds"].get<double>(), 1) + " s";
  if (!is_error) {
    const Json& all = report["figures"];
    for (const char* level : {"bust", "waist", "hip"}) {
      const Json& ease = all[std::string(level) + "_ease_cm"];
      if (ease.is_number()) {
        girths += std::string(girths.empty() ? "ease as cut: " : ", ") + level + " " +
                  fixed_number(ease.get<double>(), 1) + " cm";
      }
    }
    if (all["fit"] == "too_small") {
      girths += std::string(girths.empty() ? "" : "; ") + "cut smaller than the body at a level";
    }
    figures += ", strain " + fixed_number(100 * all["strain_p99"].get<double>(), 1) +
               " % (99th percentile), attempts " + std::to_string(all["attempts"].get<int>());
  }
  line(girths, "");
  line(figures, " class=\"small\"");
  page << "<p class=\"small\">";
  if (!is_error) {
    if (has_pictures) page << link(name, "ease.html", "ease") << " · ";
    page << link(name, "ease.json", "figures") << " · " << link(name, "dressed.json", "drape")
         << " · ";
  }
  page << link(name, "report.json", "report") << " · " << link(name, "log.txt", "log")
       << "</p>\n</article>\n";
}

void add_button(std::ostream& page, const std::string& verdict, std::size_t count) {
  page << "<button data-verdict=\"" << html_escaped(verdict) << "\">"
       << html_escaped(verdict.empty() ? "all" : verdict) << " (" << count << ")</button>\n";
}

}  // namespace

std::string contact_sheet(const RowReports& reports) {
  std::map<std::string, std::size_t> counts;
  std::size_t done = 0;
  for (const Json& report : reports) {
    if (report.is_null()) continue;
    ++counts[report["verdict"].get<std::string>()];
    ++done;
  }
  std::ostringstream page;
  page << head << "<h1>" << (done < reports.size() ? std::to_string(done) + " of " : "")
       << reports.size() << " garments</h1>\n<nav>\n";
  add_button(page, "", done);
  for (const auto& [verdict, count] : counts) add_button(page, verdict, count);
  page << "<input type=\"search\" placeholder=\"name, cause or warning\" aria-label=\"search\">\n"
       << "</nav>\n<main>\n";
  for (const Json& report : reports) {
    if (!report.is_null()) add_card(page, report);
  }
  page << "</main>\n" << script;
  return page.str();
}

}  // namespace toile
