// Why not a library: tinyobjloader 2.0.0~rc10 of Debian 12, in double precision, reads 61,746 of
// 100,000 coordinates of 17 digits as other doubles than the nearest. It takes `nan` and words for
// 0 without a message. An index out of range is a warning, and leaves no face of its polygon.
// tests/fuzz/model.cpp feeds this reader.

#include "load/model/read_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>

#include "load/json/fields.h"
#include "load/model/material_files.h"
#include "load/model/model_corner.h"
#include "load/model/model_file.h"
#include "load/model/model_numbers.h"
#include "load/model/model_report.h"
#include "load/model/model_text.h"

namespace hearth {

namespace {

namespace fs = std::filesystem;

/// Reads the text twice. First come the vertices, since faces may stand before them in the file,
/// and the number of triangles, so that no more memory is taken than they need.
class ModelReader {
 public:
  ModelReader(const fs::path& file, const LoadLimits& limits, const FileSource& files)
      : file_(file),
        limits_(limits),
        source_(files),
        report_(file),
        materials_(file, report_, limits, files) {}

  ModelRead read();

 private:
  bool readVertices(std::string_view text);
  void readPosition(const ModelLine& line);
  void readImagePlace(const ModelLine& line);
  bool countTriangles(const ModelLine& line);

  void readFaces(std::string_view text);
  void readFace(const ModelLine& line);
  void add(const ModelFace& face);
  void tellWhatHasNoArea();

  const fs::path& file_;
  const LoadLimits& limits_;
  const FileSource& source_;
  ModelReport report_;
  MaterialFiles materials_;

  std::vector<Vec3> positions_;
  std::vector<Vec2> images_;
  std::size_t positionsBefore_ = 0;  ///< the line that is read
  std::size_t imagesBefore_ = 0;
  std::size_t triangles_ = 0;  ///< those without area, too
  std::size_t polygons_ = 0;
  std::vector<ModelFace> faces_;
  std::optional<std::uint32_t> material_;  ///< of the faces that follow
  std::size_t withoutArea_ = 0;
  std::uint32_t firstWithoutArea_ = 0;  ///< line
};

ModelRead ModelReader::read() {
  ModelRead result;
  const auto text = readModelText(source_, file_, limits_.fileBytes, "name an OBJ file");
  if (text) {
    result.files.push_back(file_);
    if (readVertices(*text)) readFaces(*text);
  } else {
    report_.error(0, text.error().message, text.error().advice);
  }
  result.files.insert(result.files.end(), materials_.filesRead().begin(),
                      materials_.filesRead().end());
  result.mistakes = report_.mistakes("v, vt, f, usemtl and mtllib");
  std::ranges::move(materials_.mistakes(), std::back_inserter(result.mistakes));
  if (!report_.hasErrors() && !materials_.hasErrors())
    result.model =
        Model{std::move(faces_), std::move(materials_.used()), positions_.size(), polygons_};
  return result;
}

/// False if the faces are not worth reading.
bool ModelReader::readVertices(std::string_view text) {
  ModelLines lines(text);
  while (!report_.isFull()) {
    const auto line = lines.next();
    if (!line) return true;
    if (line->keyword == "v")
      readPosition(*line);
    else if (line->keyword == "vt")
      readImagePlace(*line);
    else if (line->keyword == "mtllib")
      materials_.read(*line);
    else if (line->keyword == "f" && !countTriangles(*line))
      return false;
  }
  return false;
}

/// `v x y z`; a weight or a colour that follows is left out.
void ModelReader::readPosition(const ModelLine& line) {
  std::array<double, 3> xyz{};
  std::string_view rest = line.rest;
  if (takeNumbers(line, rest, {kCoordinate, "x, y and z"}, xyz, report_))
    leaveOutRest(line, rest, report_);
  positions_.push_back({xyz[0], xyz[1], xyz[2]});  // after a mistake, too: the others keep theirs
}

/// `vt u` or `vt u v`; a depth that follows is left out.
void ModelReader::readImagePlace(const ModelLine& line) {
  const WantedNumbers wanted{kCoordinate, "u and v"};
  std::array<double, 2> uv{};
  std::string_view rest = line.rest;
  const bool isGood = takeNumbers(line, rest, wanted, std::span(uv).first(1), report_);
  std::string_view others = rest;
  if (isGood && takeWord(others) && takeNumbers(line, rest, wanted, std::span(uv).last(1), report_))
    leaveOutRest(line, rest, report_);
  images_.push_back({uv[0], uv[1]});
}

/// False if there are more than the limit allows.
bool ModelReader::countTriangles(const ModelLine& line) {
  std::size_t corners = 0;
  std::string_view rest = line.rest;
  while (takeWord(rest)) ++corners;
  triangles_ += std::max<std::size_t>(corners, 2) - 2;
  if (triangles_ <= limits_.meshFaces) return true;
  report_.error(line.number, fmt::format("more than {} triangles", limits_.meshFaces),
                "raise the limit with --max-mesh-faces");
  return false;
}

void ModelReader::readFaces(std::string_view text) {
  faces_.reserve(triangles_);
  ModelLines lines(text);
  while (!report_.isFull()) {
    const auto line = lines.next();
    if (!line) break;
    if (line->keyword == "f")
      ++polygons_, readFace(*line);
    else if (line->keyword == "v")
      ++positionsBefore_;
    else if (line->keyword == "vt")
      ++imagesBefore_;
    else if (line->keyword == "usemtl")
      material_ = materials_.use(*line);
    else if (line->keyword != "mtllib")
      report_.leaveOut(line->keyword, line->number);
  }
  if (polygons_ == 0)
    report_.error(0, "no faces", "export the model as polygons: lines that begin with \"f\"");
  tellWhatHasNoArea();
}

/// A polygon, as a fan from its first corner.
void ModelReader::readFace(const ModelLine& line) {
  const VertexCounts positions{positions_.size(), positionsBefore_};
  const VertexCounts images{images_.size(), imagesBefore_};
  ModelFace face{{}, {}, material_, line.number};
  std::size_t corners = 0;
  std::string_view rest = line.rest;
  while (const auto word = takeWord(rest)) {
    const std::optional<CornerIndices> corner = readCorner(*word, line, positions, images, report_);
    if (!corner) return;
    const std::size_t i = std::min<std::size_t>(corners, 2);
    face.corners[i] = positions_[corner->position];
    face.image[i] = corner->image ? images_[*corner->image] : Vec2{};
    if (++corners < 3) continue;
    add(face);
    face.corners[1] = face.corners[2];
    face.image[1] = face.image[2];
  }
  if (corners < 3)
    report_.error(line.number, fmt::format("a face of {} corner(s)", corners),
                  "give it at least three");
}

void ModelReader::add(const ModelFace& face) {
  const auto& [a, b, c] = face.corners;
  if (length(cross(b - a, c - a)) > 0) return faces_.push_back(face);
  if (withoutArea_++ == 0) firstWithoutArea_ = face.line;
}

/// After an error a vertex may lie where it should not.
void ModelReader::tellWhatHasNoArea() {
  constexpr std::string_view kAdvice = "give faces corners that are not in one line";
  if (withoutArea_ == 0 || report_.hasErrors()) return;
  if (faces_.empty())
    report_.error(firstWithoutArea_, "no face has an area", std::string(kAdvice));
  else
    report_.warning(firstWithoutArea_,
                    fmt::format("left out: {} triangle(s) without area, of {}", withoutArea_,
                                withoutArea_ + faces_.size()),
                    std::string(kAdvice));
}

}  // namespace

ModelRead readModel(const fs::path& file, const LoadLimits& limits, const FileSource& files) {
  return ModelReader(file, limits, files).read();
}

}  // namespace hearth
