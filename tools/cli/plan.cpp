#include "cli/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "level/locate.h"
#include "level/plan_bounds.h"
#include "level/thing_name.h"
#include "math/predicates.h"
#include "math/trig.h"
#include "text/html.h"

namespace hearth {

namespace {

// In units of the SVG; browsers fit it to the page.
constexpr double kLongerSide = 1600;
constexpr double kMargin = 40;
constexpr double kLegendRow = 28;
constexpr double kLegend = 3 * kLegendRow + 4;
constexpr double kLargestText = 20;
constexpr double kSmallestText = 4;  ///< smaller names are only told when pointed at
constexpr double kShotText = 12;
constexpr double kEyeRadius = 3;
constexpr double kPlayersFov = 60;  ///< of the sign; degrees
/// Of a letter, by its height: a rough mean of sans-serif type.
constexpr double kLetterWidth = 0.56;

constexpr Rgb kLowest = {54, 74, 98};
constexpr Rgb kHighest = {242, 228, 196};

constexpr std::string_view kPlanStyle =
    "text{font-family:sans-serif;text-anchor:middle;fill:#141414}"
    "path{fill:none;stroke-linecap:round}"
    ".sector{fill-rule:evenodd;stroke:none}.portalled{fill:url(#flat)}.moving{fill:url(#moving)}"
    ".solid{stroke:#141414;stroke-width:2.5}.step{stroke:#b4541e;stroke-width:1.5}"
    ".opening{stroke:#141414;stroke-width:.7;stroke-dasharray:3 4}"
    ".oneway{stroke:#c4006e;stroke-width:2.5;stroke-dasharray:7 4}"
    ".light,.sprite{stroke:#141414;stroke-width:.7}.sprite{fill:#a878c8}"
    ".mesh{fill:#c8b878;stroke:#141414;stroke-width:.5}"
    ".body{fill:#a878c8;fill-opacity:.35;stroke:#141414;stroke-width:.7}.key{text-anchor:start;"
    "font-size:14px}"
    ".shot,.player{stroke:#0a5a2c;stroke-width:1.5}.player{stroke-width:3}"
    ".shot circle,.player circle{fill:#0a5a2c;stroke:none}"
    ".shotname{fill:#0a5a2c;stroke:#fff;stroke-opacity:.85;stroke-width:3;"
    "paint-order:stroke}";

enum class Line { Opening, Step, OneWay, Solid };

struct LineStyle {
  Line line;
  std::string_view style;
  std::string_view words;
};

/// In the order in which they are drawn.
constexpr std::array kLines = {LineStyle{Line::Opening, "opening", "opening"},
                               LineStyle{Line::Step, "step", "step, sill or window"},
                               LineStyle{Line::OneWay, "oneway", "one-way portal"},
                               LineStyle{Line::Solid, "solid", "wall"}};

bool leadsBack(const Scene& scene, SectorId to, SegmentId twin) {
  return std::ranges::any_of(scene.piecesOf(scene[twin]), [&](const WallPiece& piece) {
    const Opening* opening = std::get_if<Opening>(&piece.content);
    return opening && opening->next == to;
  });
}

Line lineOf(const Scene& scene, const Segment& segment) {
  bool isOpen = false;
  bool shows = false;
  for (const WallPiece& piece : scene.piecesOf(segment)) {
    const Opening* opening = std::get_if<Opening>(&piece.content);
    if (opening && !leadsBack(scene, segment.sector, opening->twin)) return Line::OneWay;
    (opening ? isOpen : shows) = true;
  }
  if (!isOpen) return Line::Solid;
  return shows ? Line::Step : Line::Opening;
}

/// A place inside a sector with much room around it.
struct PlanPlace {
  Vec2 point;
  double room = 0;  ///< metres to the nearest wall
};

PlanPlace roomiestPlace(const Level& level, const Sector& sector, const Box& frame) {
  constexpr int kTried = 24;  // to a side
  const Box tried = intersection(frame, sector.box);
  PlanPlace best{tried.min};
  for (int j = 0; j < kTried; ++j)
    for (int i = 0; i < kTried; ++i) {
      const Vec2 size = tried.max - tried.min;
      const Vec2 p = tried.min + Vec2{size.x * (i + 0.5) / kTried, size.y * (j + 0.5) / kTried};
      double room = std::numeric_limits<double>::infinity();
      for (const Segment& wall : level.segmentsOf(sector))
        room = std::min(room, length(nearestOnSegment(wall.p0, wall.p1, p) - p));
      if (room > best.room && contains(level, sector, p)) best = {p, room};
    }
  return best;
}

std::string hex(Rgb color) { return fmt::format("#{:02x}{:02x}{:02x}", color.r, color.g, color.b); }

class PlanDrawing {
 public:
  explicit PlanDrawing(const Scene& scene)
      : scene_(scene),
        frame_(planBounds(scene.level())),
        size_(frame_.max - frame_.min),
        scale_(kLongerSide / std::max(size_.x, size_.y)) {}

  std::string svg() {
    begin();
    drawSectors();
    drawMovers();
    for (const LineStyle& style : kLines) drawLines(style);
    drawMeshes();
    drawSprites();
    drawLights();
    drawCameras();
    drawNames();
    drawShotNames();
    drawLegend();
    out_ += "</svg>\n";
    return std::move(out_);
  }

 private:
  template <typename... Values>
  void add(fmt::format_string<Values...> text, Values&&... values) {
    fmt::format_to(std::back_inserter(out_), text, std::forward<Values>(values)...);
  }

  double width() const { return scale_ * size_.x + 2 * kMargin; }
  double height() const { return scale_ * size_.y + 2 * kMargin + kLegend; }
  Vec2 toPaper(Vec2 p) const { return scale_ * (p - frame_.min) + Vec2{kMargin, kMargin}; }
  std::string point(Vec2 p) const {
    const Vec2 at = toPaper(p);
    return fmt::format("{:.2f},{:.2f}", at.x, at.y);
  }

  void begin() {
    add("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\">\n"
        "<title>{}</title>\n<style>{}</style>\n"
        "<defs><pattern id=\"flat\" width=\"9\" height=\"9\" patternUnits=\"userSpaceOnUse\" "
        "patternTransform=\"rotate(45)\"><rect width=\"2\" height=\"9\" fill=\"#1e6ec8\" "
        "fill-opacity=\".55\"/></pattern>"
        "<pattern id=\"moving\" width=\"9\" height=\"9\" patternUnits=\"userSpaceOnUse\" "
        "patternTransform=\"rotate(-45)\"><rect width=\"3\" height=\"9\" fill=\"#128a58\" "
        "fill-opacity=\".6\"/></pattern></defs>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        width(), height(), escaped(scene_.level().name), kPlanStyle);
  }

  std::string outline(const Sector& sector) const {
    std::string path;
    for (const Loop& loop : sector.loops) {
      for (std::size_t i = 0; i < loop.count; ++i)
        (path += i == 0 ? "M" : "L") += point(scene_.level().segments[loop.first.index() + i].p0);
      path += "Z";
    }
    return path;
  }

  std::string words(const Sector& sector) const {
    return fmt::format("{}: floor {:g}, ceiling {:g}, light {:g}", escaped(sector.name),
                       scene_.zFloor(sector), scene_.zCeiling(sector), sector.light);
  }

  /// Between those of the lowest and of the highest floor.
  Rgb colorAt(double z) const {
    const auto [low, high] =
        std::ranges::minmax(scene_.geometry().sectors, {}, &SectorGeometry::zFloor);
    const double range = high.zFloor - low.zFloor;
    const double fraction = range > 0 ? (z - low.zFloor) / range : 1;
    const auto mixed = [fraction](std::uint8_t a, std::uint8_t b) {
      return static_cast<std::uint8_t>(std::lround(a + fraction * (b - a)));
    };
    return {mixed(kLowest.r, kHighest.r), mixed(kLowest.g, kHighest.g),
            mixed(kLowest.b, kHighest.b)};
  }

  void drawSectors() {
    std::vector<const Sector*> sectors;
    for (const Sector& sector : scene_.level().sectors) sectors.push_back(&sector);
    std::ranges::stable_sort(sectors, {},
                             [&](const Sector* sector) { return scene_.zFloor(*sector); });
    for (const Sector* sector : sectors) {
      const std::string path = outline(*sector);
      add("<path class=\"sector\" fill-opacity=\".85\" style=\"fill:{}\" d=\"{}\">"
          "<title>{}</title></path>\n",
          hex(colorAt(scene_.zFloor(*sector))), path, words(*sector));
      if (sector->floor.flatPortal || sector->ceiling.flatPortal)
        add("<path class=\"sector portalled\" d=\"{}\"><title>{}, flat portal</title></path>\n",
            path, words(*sector));
    }
  }

  /// Sectors of which a flat moves.
  void drawMovers() {
    for (const Mover& mover : scene_.level().movers)
      for (const SectorId id : mover.sectors) {
        const Sector& sector = scene_.level()[id];
        const bool isFloor = mover.part == FlatPart::Floor;
        add("<path class=\"sector moving\" d=\"{}\"><title>{}; mover {}: {} from {:g} to {:g}"
            "</title></path>\n",
            outline(sector), words(sector), escaped(mover.name), name(mover.part),
            isFloor ? scene_.zFloor(sector) : scene_.zCeiling(sector), mover.to);
      }
  }

  void drawLines(const LineStyle& style) {
    std::string path;
    for (const Segment& segment : scene_.level().segments)
      if (lineOf(scene_, segment) == style.line)
        path += fmt::format("M{}L{}", point(segment.p0), point(segment.p1));
    if (!path.empty()) add("<path class=\"{}\" d=\"{}\"/>\n", style.style, path);
  }

  /// Further down where another name or mark is in the way; not at all where there is no room.
  void drawNames() {
    for (const Sector& sector : scene_.level().sectors) {
      if (!overlap(frame_, sector.box)) continue;
      const PlanPlace place = roomiestPlace(scene_.level(), sector, frame_);
      const std::string heights =
          fmt::format("{:g} to {:g}", scene_.zFloor(sector), scene_.zCeiling(sector));
      const auto letters = static_cast<double>(std::max(sector.name.size(), heights.size()));
      const double room = scale_ * place.room;
      const double size = std::min(kLargestText, 2 * room / (kLetterWidth * letters));
      if (size < kSmallestText) continue;
      const Vec2 half{kLetterWidth * letters * size / 2, size};
      const Vec2 middle = toPaper(place.point);
      for (double down = 0; down < std::max(room, size); down += size / 2)
        if (takes(middle + Vec2{0, down}, half)) {
          drawName(sector.name, heights, middle + Vec2{0, down}, size);
          break;
        }
    }
  }

  bool takes(Vec2 middle, Vec2 half) {
    const Box box{middle - half, middle + half};
    const auto isInTheWay = [&](const Box& other) { return overlap(box, other); };
    if (std::ranges::any_of(taken_, isInTheWay)) return false;
    taken_.push_back(box);
    return true;
  }

  void drawName(std::string_view name, std::string_view heights, Vec2 at, double size) {
    add("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.2f}\">{}<tspan x=\"{:.2f}\" "
        "dy=\"1.1em\" font-size=\"70%\">{}</tspan></text>\n",
        at.x, at.y, size, escaped(name), at.x, heights);
  }

  void drawLights() {
    for (const LightSource& light : scene_.level().lights) {
      if (light.isArea()) continue;
      if (light.sun) {
        drawSun(light);
        continue;
      }
      const Vec2 at = toPaper(light.position.xy());
      const double radius = std::max(5.0, scale_ * light.radius);
      taken_.push_back({at - Vec2{radius, radius}, at + Vec2{radius, radius}});
      const std::string color = hex({light.color[0], light.color[1], light.color[2]});
      add("<circle class=\"light\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" fill=\"{}\">"
          "<title>light at z {:g}, {}, radius {:g}{}</title></circle>\n",
          at.x, at.y, radius, color, light.position.z,
          light.curve.empty()
              ? fmt::format("intensity {:g}, falloff {:g}", light.intensity, light.falloff)
              : std::string("with a curve"),
          light.radius,
          light.spot ? fmt::format(", spot of {:g} degrees towards angle {:g}, pitch {:g}",
                                   light.spot->outer(), light.spot->angle(), light.spot->pitch())
                     : "");
    }
  }

  /// In the margin, on the side from which it shines. Its ray is as long as the sun is low.
  void drawSun(const LightSource& light) {
    const Sun& sun = *light.sun;
    const Vec2 towards = directionAt(sun.angle(), 0).xy();
    const Vec2 half = 0.5 * scale_ * size_ + Vec2{kMargin / 2, kMargin / 2};
    const double away = std::min(half.x / std::max(std::abs(towards.x), 1e-9),
                                 half.y / std::max(std::abs(towards.y), 1e-9));
    const Vec2 at = toPaper(frame_.min + 0.5 * size_) + away * towards;
    const std::string title = fmt::format(
        "<title>sun towards angle {:g}, pitch {:g}, intensity {:g}, size {:g} degrees</title>",
        sun.angle(), sun.pitch(), light.intensity, sun.size());
    drawSunSign(at, -1 * towards, length(sun.direction().xy()),
                hex({light.color[0], light.color[1], light.color[2]}), title);
  }

  /// A disc, and a line along its rays.
  void drawSunSign(Vec2 at, Vec2 along, double slant, std::string_view color,
                   std::string_view title) {
    constexpr double kRadius = 7;
    constexpr double kLongestRay = 24;
    const Vec2 end = at + (kRadius + kLongestRay * slant) * along;
    taken_.push_back({at - Vec2{kRadius, kRadius}, at + Vec2{kRadius, kRadius}});
    add("<g class=\"light\">{}<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\"/>"
        "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" fill=\"{}\"/></g>\n",
        title, at.x, at.y, end.x, end.y, at.x, at.y, kRadius, color);
  }

  static std::string diamond(Vec2 at) {
    constexpr double kHalf = 5;
    return fmt::format("M{0:.2f},{1:.2f}l{2},{2}l-{2},{2}l-{2},-{2}z", at.x, at.y - kHalf, kHalf);
  }

  /// Their faces, from above.
  void drawMeshes() {
    for (const Mesh& mesh : scene_.level().meshes) {
      std::string faces;
      for (const MeshFace& face : scene_.level().facesOf(mesh))
        for (std::size_t i = 0; i < face.corners.size(); ++i) {
          const Vec2 at = toPaper(face.corners[i].xy());
          faces += fmt::format("{}{:.2f},{:.2f}{}", i == 0 ? 'M' : 'L', at.x, at.y,
                               i + 1 == face.corners.size() ? "z" : "");
        }
      add("<path class=\"mesh\" d=\"{}\"><title>mesh {} of {} faces at z {:g}</title></path>\n",
          faces, escaped(nameOf(scene_.level(), mesh)), mesh.faceCount, mesh.position.z);
    }
  }

  /// A solid one with its body.
  void drawSprites() {
    for (const Sprite& sprite : scene_.level().sprites) {
      const Vec2 at = toPaper(sprite.position.xy());
      const double radius = std::max(5.0, sprite.body ? scale_ * sprite.body->radius : 0.0);
      taken_.push_back({at - Vec2{radius, radius}, at + Vec2{radius, radius}});
      if (sprite.body)
        add("<circle class=\"body\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n", at.x, at.y,
            scale_ * sprite.body->radius);
      const std::string solid =
          sprite.body ? fmt::format(", solid, {:g} m high", sprite.body->height) : "";
      add("<path class=\"sprite\" d=\"{}\"><title>sprite {} at z {:g}{}</title></path>\n",
          diamond(at), escaped(nameOf(scene_.level(), sprite)), sprite.position.z, solid);
    }
  }

  /// Where one looks from, a dot, and the two sides of what is in view; the box around these.
  Box drawEye(std::string_view style, Vec2 eye, double angle, double fov, std::string_view title) {
    constexpr double kLength = 18;
    const auto end = [&](double turned) {
      const auto [sin, cos] = sinCosDegrees(angle + turned);
      return eye + kLength * Vec2{cos, sin};
    };
    const double half = std::min(fov / 2, 80.0);
    const Vec2 left = end(-half);
    const Vec2 right = end(half);
    add("<g class=\"{}\">{}<path d=\"M{:.2f},{:.2f}L{:.2f},{:.2f}L{:.2f},{:.2f}\"/>"
        "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\"/></g>\n",
        style, title, left.x, left.y, eye.x, eye.y, right.x, right.y, eye.x, eye.y, kEyeRadius);
    Box box;
    for (const Vec2 corner : {left, eye, right}) box.add(corner);
    return box;
  }

  Box drawCamera(std::string_view style, std::string_view name, Vec3 eye, double angle,
                 double fov) {
    const std::string title = fmt::format("<title>{} at z {:g}</title>", escaped(name), eye.z);
    return taken_.emplace_back(drawEye(style, toPaper(eye.xy()), angle, fov, title));
  }

  void drawCameras() {
    for (const Shot& shot : scene_.level().shots)
      shots_.push_back(drawCamera("shot", "shot " + shot.name, shot.eye, shot.angle, shot.fov));
    if (const auto& player = scene_.level().player)
      drawCamera("player", "player", player->eye, player->angle, kPlayersFov);
  }

  /// Beside its sign, where nothing is in the way; else further off, and at last not at all.
  void drawShotName(std::string_view name, const Box& sign) {
    constexpr std::array kSides = {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1},  Vec2{0, -1},
                                   Vec2{1, 1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{-1, -1}};
    const Vec2 half{kLetterWidth * static_cast<double>(name.size()) * kShotText / 2, kShotText / 2};
    const Vec2 middle = 0.5 * (sign.min + sign.max);
    for (const double gap : {kEyeRadius + 1, kShotText, 2 * kShotText})
      for (const Vec2 side : kSides) {
        const Vec2 away = 0.5 * (sign.max - sign.min) + half + Vec2{gap, gap};
        const Vec2 at = middle + Vec2{side.x * away.x, side.y * away.y};
        if (!isOnPaper(at, half) || !takes(at, half)) continue;
        // Letters without descenders reach up to 0.7 of the size from the line they stand on.
        add("<text class=\"shotname\" x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{}\">{}</text>\n", at.x,
            at.y + 0.35 * kShotText, kShotText, escaped(name));
        return;
      }
  }

  bool isOnPaper(Vec2 middle, Vec2 half) const {
    return middle.x > half.x && middle.x + half.x < width() && middle.y > half.y &&
           middle.y + half.y < height() - kLegend - 10;
  }

  void drawShotNames() {
    for (std::size_t i = 0; i < shots_.size(); ++i)
      drawShotName(scene_.level().shots[i].name, shots_[i]);
  }

  /// The words of an entry of the key; the column of the next one.
  double explain(std::string_view words, double column, double row) {
    add("<text class=\"key\" x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n", column, row + 5, words);
    return column + 20 + 8 * static_cast<double>(words.size());
  }

  void drawKeyOfLines(double row) {
    double column = kMargin;
    for (const LineStyle& style : kLines) {
      add("<path class=\"{}\" d=\"M{:.2f},{:.2f}h36\"/>\n", style.style, column, row);
      column = explain(style.words, column + 44, row);
    }
    add("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"36\" height=\"16\" fill=\"url(#flat)\"/>\n",
        column, row - 8);
    column = explain("flat portal", column + 44, row);
    add("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"36\" height=\"16\" fill=\"url(#moving)\"/>\n",
        column, row - 8);
    explain("floor or ceiling moves", column + 44, row);
  }

  void drawKeyOfSigns(double row) {
    add("<circle class=\"light\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"5\" fill=\"#ffe8c8\"/>\n",
        kMargin + 18, row);
    double column = explain("light", kMargin + 44, row);
    drawSunSign({column + 8, row}, {1, 0}, 0.5, "#ffe8c8", "");
    column = explain("sun, and the way it shines", column + 36, row);
    add("<path class=\"mesh\" d=\"M{:.2f},{:.2f}h16v10h-16zl16,10\"/>\n", column, row - 5);
    column = explain("mesh", column + 28, row);
    add("<path class=\"sprite\" d=\"{}\"/>\n", diamond({column + 10, row}));
    column = explain("sprite", column + 28, row);
    drawEye("player", {column + 10, row}, 0, kPlayersFov, "");
    column = explain("player", column + 44, row);
    drawEye("shot", {column + 10, row}, 0, kPlayersFov, "");
    explain("shot: from the dot, into the angle", column + 44, row);
  }

  void drawScale(double row) {
    const double metres = std::pow(10, std::floor(std::log10(kLongerSide / 4 / scale_)));
    add("<path class=\"solid\" d=\"M{:.2f},{:.2f}h{:.2f}\"/>\n", kMargin, row, scale_ * metres);
    explain(fmt::format("{:g} m", metres), kMargin + scale_ * metres + 8, row);
  }

  void drawLegend() {
    const double row = height() - kLegend + 10;
    add("<rect y=\"{:.2f}\" width=\"100%\" height=\"{}\" fill=\"#fff\"/>\n",
        height() - kLegend - 10, kLegend + 10);
    drawKeyOfLines(row);
    drawKeyOfSigns(row + kLegendRow);
    drawScale(row + 2 * kLegendRow);
  }

  Scene scene_;
  Box frame_;
  Vec2 size_;
  double scale_;            ///< units per metre
  std::vector<Box> taken_;  ///< on the paper, by what names must not cover
  std::vector<Box> shots_;  ///< on the paper: the signs of the level's shots
  std::string out_;
};

}  // namespace

std::string planOf(const Scene& scene) { return PlanDrawing(scene).svg(); }

}  // namespace hearth
