#include "peers/llvmpipe.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
// After the types that it needs:
#include <GL/glext.h>
#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <string_view>
#include <type_traits>
#include <utility>

namespace hearth {

namespace {

constexpr const char* kOsMesaLibrary = "libOSMesa.so.8";
constexpr int kDepthBits = 24;
// Between these depths a face shows, in metres.
constexpr double kNear = 0.1;
constexpr double kFar = 100;

/// Its place on the image and in the world: what OpenGL calls T2F_V3F.
using Vertex = std::array<float, 5>;

Vertex cornerOf(const MeshFace& face, std::size_t i) {
  const Vec3 p = face.corners[i];
  const Vec2 t = face.image[i];
  return {static_cast<float>(t.x), static_cast<float>(t.y), static_cast<float>(p.x),
          static_cast<float>(p.y), static_cast<float>(p.z)};
}

/// Corners that several faces have, once.
struct IndexedFaces {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
};

IndexedFaces indexed(std::span<const MeshFace> faces, TextureId texture) {
  IndexedFaces all;
  std::map<Vertex, std::uint32_t> known;
  for (const MeshFace& face : faces) {
    if (face.texture != texture) continue;
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const auto next = static_cast<std::uint32_t>(all.vertices.size());
      const auto [vertex, isNew] = known.emplace(cornerOf(face, i), next);
      if (isNew) all.vertices.push_back(vertex->first);
      all.indices.push_back(vertex->second);
    }
  }
  return all;
}

std::vector<std::uint8_t> rgbaOf(const Image& image) {
  std::vector<std::uint8_t> bytes;
  for (const Rgb pixel : image.pixels())
    bytes.insert(bytes.end(), {pixel.r, pixel.g, pixel.b, std::uint8_t{255}});
  return bytes;
}

/// From the world to what OpenGL clips, column by column.
std::array<double, 16> clipMatrix(const Projection& projection, ImageSize size) {
  const double acrossPerSlant = 2 * projection.distancePx() / size.width;
  const double upPerSlope = 2 * projection.distancePx() / size.height;
  const double horizon = 1 - 2 * projection.horizonRow() / size.height;
  const double zPerDepth = (kFar + kNear) / (kFar - kNear);
  const double zAtEye = -2 * kFar * kNear / (kFar - kNear);
  std::array<double, 16> matrix{};
  // Columns for x, y and z, then that of the eye.
  const auto column = [&](std::size_t i, CameraPoint p, double up, double z) {
    matrix[4 * i] = acrossPerSlant * p.lateral;
    matrix[4 * i + 1] = upPerSlope * up + horizon * p.depth;
    matrix[4 * i + 2] = zPerDepth * p.depth + z;
    matrix[4 * i + 3] = p.depth;
  };
  column(0, projection.toCameraDirection({1, 0}), 0, 0);
  column(1, projection.toCameraDirection({0, 1}), 0, 0);
  column(2, {0, 0}, 1, 0);
  column(3, projection.toCamera({0, 0}), -projection.eye().z, zAtEye);
  return matrix;
}

}  // namespace

/// Of OSMesa and OpenGL, with the types that their headers give them.
struct Llvmpipe::Functions {
  explicit Functions(void* library)
      : getProcAddress(reinterpret_cast<decltype(&OSMesaGetProcAddress)>(
            dlsym(library, "OSMesaGetProcAddress"))) {
    const auto find = [&](auto*& function, const char* name) {
      function =
          reinterpret_cast<std::remove_reference_t<decltype(function)>>(getProcAddress(name));
    };
    createContext =
        reinterpret_cast<decltype(createContext)>(dlsym(library, "OSMesaCreateContextExt"));
    destroyContext =
        reinterpret_cast<decltype(destroyContext)>(dlsym(library, "OSMesaDestroyContext"));
    makeCurrent = reinterpret_cast<decltype(makeCurrent)>(dlsym(library, "OSMesaMakeCurrent"));
    pixelStore = reinterpret_cast<decltype(pixelStore)>(dlsym(library, "OSMesaPixelStore"));
    find(getString, "glGetString");
    find(enable, "glEnable");
    find(texEnvi, "glTexEnvi");
    find(genTextures, "glGenTextures");
    find(bindTexture, "glBindTexture");
    find(texParameteri, "glTexParameteri");
    find(texImage2D, "glTexImage2D");
    find(genBuffers, "glGenBuffers");
    find(bindBuffer, "glBindBuffer");
    find(bufferData, "glBufferData");
    find(loadMatrixd, "glLoadMatrixd");
    find(clear, "glClear");
    find(interleavedArrays, "glInterleavedArrays");
    find(drawElements, "glDrawElements");
    find(finish, "glFinish");
  }

  decltype(&OSMesaGetProcAddress) getProcAddress;
  decltype(&OSMesaCreateContextExt) createContext;
  decltype(&OSMesaDestroyContext) destroyContext;
  decltype(&OSMesaMakeCurrent) makeCurrent;
  decltype(&OSMesaPixelStore) pixelStore;
  decltype(&glGetString) getString;
  decltype(&glEnable) enable;
  decltype(&glTexEnvi) texEnvi;
  decltype(&glGenTextures) genTextures;
  decltype(&glBindTexture) bindTexture;
  decltype(&glTexParameteri) texParameteri;
  decltype(&glTexImage2D) texImage2D;
  decltype(&glGenBuffers) genBuffers;
  decltype(&glBindBuffer) bindBuffer;
  decltype(&glBufferData) bufferData;
  decltype(&glLoadMatrixd) loadMatrixd;
  decltype(&glClear) clear;
  decltype(&glInterleavedArrays) interleavedArrays;
  decltype(&glDrawElements) drawElements;
  decltype(&glFinish) finish;
};

tl::expected<std::shared_ptr<Llvmpipe>, std::string> Llvmpipe::of(std::span<const MeshFace> faces,
                                                                  const std::vector<Image>& images,
                                                                  ImageSize size) {
  // Read when the first context is made: no threads but the caller's.
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  setenv("LP_NUM_THREADS", "0", 1);
  // Never closed: what it loads with it need not bear that.
  void* library = dlopen(kOsMesaLibrary, RTLD_NOW | RTLD_LOCAL);
  if (!library) return tl::unexpected<std::string>("Mesa is not here: apt-get install libosmesa6");
  std::shared_ptr<Llvmpipe> made(new Llvmpipe(std::make_shared<const Functions>(library), size));
  if (!made->start()) return tl::unexpected<std::string>("Mesa draws with no llvmpipe");
  std::set<std::size_t> added;
  for (const MeshFace& face : faces)
    if (added.insert(face.texture.index()).second)
      made->add(faces, images[face.texture.index()], face.texture);
  return made;
}

Llvmpipe::Llvmpipe(std::shared_ptr<const Functions> gl, ImageSize size)
    : gl_(std::move(gl)),
      size_(size),
      pixels_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)) {}

bool Llvmpipe::start() {
  context_ = {gl_->createContext(OSMESA_BGRA, kDepthBits, 0, 0, nullptr), gl_->destroyContext};
  if (!context_ || !gl_->makeCurrent(context_.get(), pixels_.data(), GL_UNSIGNED_BYTE, size_.width,
                                     size_.height))
    return false;
  const auto* renderer = reinterpret_cast<const char*>(gl_->getString(GL_RENDERER));
  if (!renderer || !std::string_view(renderer).starts_with("llvmpipe")) return false;
  gl_->pixelStore(OSMESA_Y_UP, 0);
  for (const GLenum option : {GL_DEPTH_TEST, GL_CULL_FACE, GL_TEXTURE_2D}) gl_->enable(option);
  gl_->texEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  return true;
}

void Llvmpipe::add(std::span<const MeshFace> faces, const Image& image, TextureId texture) {
  const IndexedFaces all = indexed(faces, texture);
  Batch batch{0, 0, 0, static_cast<int>(all.indices.size())};
  gl_->genTextures(1, &batch.texture);
  gl_->bindTexture(GL_TEXTURE_2D, batch.texture);
  gl_->texParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_->texParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl_->texImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width(), image.height(), 0, GL_RGBA,
                  GL_UNSIGNED_BYTE, rgbaOf(image).data());
  const auto fill = [&](unsigned& buffer, GLenum target, const auto& values) {
    gl_->genBuffers(1, &buffer);
    gl_->bindBuffer(target, buffer);
    gl_->bufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof values[0]),
                    values.data(), GL_STATIC_DRAW);
  };
  fill(batch.vertices, GL_ARRAY_BUFFER, all.vertices);
  fill(batch.indices, GL_ELEMENT_ARRAY_BUFFER, all.indices);
  batches_.push_back(batch);
}

PixelRows Llvmpipe::draw(const Projection& projection) {
  gl_->loadMatrixd(clipMatrix(projection, size_).data());
  // Faces cover every pixel, but to clear the colours is faster than to keep them.
  gl_->clear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
  for (const Batch& batch : batches_) {
    gl_->bindTexture(GL_TEXTURE_2D, batch.texture);
    gl_->bindBuffer(GL_ARRAY_BUFFER, batch.vertices);
    gl_->bindBuffer(GL_ELEMENT_ARRAY_BUFFER, batch.indices);
    gl_->interleavedArrays(GL_T2F_V3F, 0, nullptr);
    gl_->drawElements(GL_TRIANGLES, batch.count, GL_UNSIGNED_INT, nullptr);
  }
  gl_->finish();  // copies the picture to the memory
  return {pixels_.data(), static_cast<std::size_t>(size_.width), size_.width, size_.height};
}

}  // namespace hearth
