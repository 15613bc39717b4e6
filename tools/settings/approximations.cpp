#include "settings/approximations.h"

#include <array>

namespace hearth {

namespace {

using Of = Approximation::Of;

constexpr std::array kApproximations = {
    Approximation{
        Option::Texel, Of::Bake, "1|0.5|0.25|0.125|0.0625|0.03125",
        "light is interpolated over a texel: edges of shadows are blurred and moved by up "
        "to one; elsewhere an eighth of its side, squared, by how fast light bends",
        "engine/light/lit_surface.h"},
    Approximation{
        Option::Samples, Of::Bake, "1|4|16|64|auto",
        "what a texel sees is known to 1/samples of it, but near edges that run along its "
        "grid to 1/sqrt(samples); auto: straight edges exactly",
        "engine/light/baking/baked_surface.h"},
    Approximation{
        Option::SoftSamples, Of::Bake, "0|4|16|36|64|256",
        "the fraction of a ball that is seen: less than a level of 255 with 36 at straight edges, "
        "falling at the rate of 1/sqrt(soft samples) at least",
        "engine/light/baking/light_visibility.h"},
    Approximation{Option::CutOff, Of::Bake, "1|4|16",
                  "as many levels as it says, of each light that is left out",
                  "engine/level/light_source.h"},
    Approximation{
        Option::GatherError, Of::Bake, "0.25|0.5|1|2|4|8",
        "between the places where light of the sky and of shining surfaces is gathered, as "
        "many levels as it says; of light that bounces, three times as many",
        "engine/light/gather/light_lattice.h"},
    Approximation{Option::MiddleShadows, Of::Bake, "holes|solid",
                  "solid: all the light that comes through holes of middle textures",
                  "engine/light/rays/raytracer.cpp"},
    Approximation{Option::MoverStages, Of::Movers, "0|1|3|7",
                  "between two heights that are baked light changes evenly: shadows of what moves "
                  "fade from one place to the next",
                  "engine/light/blended_light.h"},
    Approximation{Option::TextureFilter, Of::Frame, "nearest|bilinear|mipmapped",
                  "none of the nearest texel, which is what levels are defined to show; mixtures "
                  "and means differ by up to the contrast of neighbouring texels",
                  "engine/render/pixel_kernels.h"},
    Approximation{Option::LightFilter, Of::Frame, "nearest|bilinear",
                  "nearest: half of the difference of neighbouring texels, and steps that are seen",
                  "engine/render/pixel_kernels.h"},
    Approximation{Option::PixelSize, Of::Frame, "1|2|3|4",
                  "all edges are moved by up to half of a square; what is smaller comes and goes",
                  "engine/render/renderer.cpp"},
};

}  // namespace

std::span<const Approximation> approximations() { return kApproximations; }

std::vector<std::string_view> triedOf(const Approximation& approximation) {
  return split(approximation.tried, '|');
}

}  // namespace hearth
