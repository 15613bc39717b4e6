#include "cli/check/check_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <ostream>
#include <string_view>

#include "files/replace_file.h"
#include "text/base64.h"
#include "text/html.h"

namespace hearth {

namespace {

constexpr std::string_view kCheckPageStyle = R"css(section { margin-top: 2rem; }
article { margin: 1rem 0; padding-top: 1rem; border-top: 1px solid GrayText; }
code { display: block; margin-bottom: .75rem; overflow-x: auto; white-space: pre; }
.row { display: grid; gap: 1.5rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 30rem), 1fr)); }
.grid { display: grid; gap: 1.5rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 20rem), 1fr)); }
.grid { margin-top: 1.5rem; }
.grid, .row { align-items: start; }
figcaption { overflow-wrap: anywhere; }
img { display: block; width: 100%; height: auto; image-rendering: pixelated; }
.pair { position: relative; }
.pair .actual { position: absolute; inset: 0; clip-path: inset(0 0 0 var(--at)); }
.pair::after { content: ""; position: absolute; inset: 0 auto 0 var(--at); width: 2px; margin-left: -1px;
  background: white; box-shadow: 0 0 2px 1px black; }
input { display: block; width: 100%; margin: .5rem 0 0; }
.sides { display: flex; justify-content: space-between; gap: 1rem; }
)css";

constexpr std::string_view kSlider =
    R"html(<input type="range" min="0" max="100" value="50" autocomplete="off" aria-label="where expected ends and actual begins"
oninput="this.closest('figure').style.setProperty('--at', this.value + '%')">
<figcaption class="sides"><span>left: expected</span><span>right: actual</span></figcaption>
)html";

/// One page on its way out. Whether all of it arrived is asked at the end.
class Page {
 public:
  explicit Page(std::ostream& out) : out_(out) {}

  void add(const LevelFindings& findings) {
    out_ << fmt::format("<section>\n<h2>{}</h2>\n", escaped(findings.level));
    if (findings.shots.empty())
      out_ << "<p>This level could not be checked; the command printed why.</p>\n";
    else
      addShots(findings);
    out_ << "</section>\n";
  }

  bool hasReadAll() const { return hasReadAll_; }

 private:
  void addShots(const LevelFindings& findings) {
    const auto asKept = std::ranges::count_if(findings.shots, &ShotFinding::isAsKept);
    const auto others = std::ssize(findings.shots) - asKept;
    out_ << fmt::format("<p>{} as kept, {} not.</p>\n", asKept, others);
    if (others > 0)
      out_ << fmt::format("<p>To keep all as they are now:</p>\n<code>{}</code>\n",
                          escaped(findings.acceptCommand));
    for (const ShotFinding& shot : findings.shots)
      if (!shot.isAsKept) addChanged(shot);
    out_ << "<div class=\"grid\">\n";
    for (const ShotFinding& shot : findings.shots)
      if (shot.isAsKept) addKept(shot);
    out_ << "</div>\n";
  }

  void addKept(const ShotFinding& shot) {
    out_ << "<figure>\n";
    if (shot.expected) addPicture(*shot.expected, shot.shot, "");
    out_ << fmt::format("<figcaption>{}: {}</figcaption>\n</figure>\n", escaped(shot.shot),
                        escaped(shot.words));
  }

  void addChanged(const ShotFinding& shot) {
    out_ << fmt::format("<article>\n<h3>{}</h3>\n<p>{}.</p>\n", escaped(shot.shot),
                        escaped(shot.words));
    if (!shot.command.empty()) out_ << fmt::format("<code>{}</code>\n", escaped(shot.command));
    out_ << "<div class=\"row\">\n";
    if (shot.difference) {
      addSlider(shot);
      addFigure(*shot.difference, "difference, amplified");
    } else {
      if (shot.expected) addFigure(*shot.expected, "expected");
      if (shot.actual) addFigure(*shot.actual, "actual");
    }
    out_ << "</div>\n</article>\n";
  }

  void addSlider(const ShotFinding& shot) {
    out_ << "<figure style=\"--at: 50%\">\n<div class=\"pair\">\n";
    addPicture(*shot.expected, "expected", "");
    addPicture(*shot.actual, "actual", "actual");
    out_ << "</div>\n" << kSlider << "</figure>\n";
  }

  void addFigure(const std::filesystem::path& picture, std::string_view caption) {
    out_ << "<figure>\n";
    addPicture(picture, caption, "");
    out_ << fmt::format("<figcaption>{}</figcaption>\n</figure>\n", caption);
  }

  void addPicture(const std::filesystem::path& picture, std::string_view alt,
                  std::string_view cssClass) {
    out_ << fmt::format("<img class=\"{}\" alt=\"{}\" src=\"data:image/png;base64,", cssClass,
                        escaped(alt));
    std::ifstream file(picture, std::ios::binary);
    hasReadAll_ &= file.is_open();
    std::array<char, 3 << 14> bytes;  // a multiple of three: only the last group is padded
    do {
      file.read(bytes.data(), std::ssize(bytes));
      out_ << base64({bytes.data(), static_cast<std::size_t>(file.gcount())});
    } while (file);
    out_ << "\">\n";
  }

  std::ostream& out_;
  bool hasReadAll_ = true;
};

}  // namespace

tl::expected<void, std::string> writeCheckPage(const std::filesystem::path& path,
                                               std::span<const LevelFindings> levels) {
  return replaceFile(path, [&](std::ostream& out) {
    out << pageBegin("hearth check", kCheckPageStyle) << "<h1>hearth check</h1>\n";
    Page page(out);
    for (const LevelFindings& findings : levels) page.add(findings);
    out << kPageEnd;
    return page.hasReadAll();
  });
}

}  // namespace hearth
