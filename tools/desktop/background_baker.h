#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "inputs/bake_cache.h"
#include "inputs/progress.h"
#include "light/bake_progress.h"
#include "light/bakery.h"
#include "light/rebake.h"
#include "load/source.h"
#include "model/model_figures.h"
#include "render/renderer.h"
#include "settings/options.h"
#include "viewer/walk/rest_light.h"

namespace hearth {

/// A version of a level with its light, as it is drawn.
struct LitLevel {
  LitLevel(std::shared_ptr<const LoadedLevel> level, std::shared_ptr<const LevelSource> itsSource,
           std::optional<ModelFigures> itsModel, DrawnTextures textures,
           std::shared_ptr<const BakedLight> baked, const DrawSettings& settings)
      : loaded(std::move(level)),
        source(std::move(itsSource)),
        model(std::move(itsModel)),
        light(std::move(baked)),
        renderer(loaded->scene(), std::move(textures), *light, settings) {}
  LitLevel(const LitLevel&) = delete;
  LitLevel& operator=(const LitLevel&) = delete;

  std::shared_ptr<const LoadedLevel> loaded;
  std::shared_ptr<const LevelSource> source;
  std::optional<ModelFigures> model;  ///< if the level was made for one and has been reloaded
  std::shared_ptr<const BakedLight> light;
  Renderer renderer;
};

/// The same level with other draw settings.
std::shared_ptr<const LitLevel> redrawn(const LitLevel& lit, const DrawSettings& settings);

/// The state of a version of a level.
struct LevelNews {
  std::vector<std::string> warnings = {};
  /// Why the files cannot be shown as they are now. Then `level`, if any, is an earlier version.
  std::vector<std::string> mistakes = {};
  std::shared_ptr<const LitLevel> level = nullptr;
  bool isDraft = false;  ///< better light follows
  /// The light of a level, `restOf`, with its movers at rest elsewhere.
  std::shared_ptr<const RestLight> rest = nullptr;
  std::shared_ptr<const LoadedLevel> restOf = nullptr;
};

/// Loads and bakes a level on request, in a thread of its own with low priority. A new request
/// cancels the one before. With `--light-from` light is taken from that file instead.
class BackgroundBaker {
 public:
  /// The time in which the next file of one save follows. Until its lights follow, a level that is
  /// copied over another may be wrong.
  static constexpr std::chrono::milliseconds kNextFile{50};

  /// Bakes `loaded` first, with the settings of the command line above those of the file. Mistakes
  /// are reported unless another file follows within `nextFile`.
  BackgroundBaker(const OptionValues& values, std::shared_ptr<const LoadedLevel> loaded,
                  std::shared_ptr<const LevelSource> source, std::chrono::milliseconds nextFile);
  ~BackgroundBaker();
  BackgroundBaker(const BackgroundBaker&) = delete;
  BackgroundBaker& operator=(const BackgroundBaker&) = delete;

  enum class Changed { Lights, Anything };
  /// Loads the level anew: all of it, or only its lights if only their file has changed.
  void reload(Changed changed);
  /// From now on this unsaved text replaces that of the lights file. If texts follow quickly, their
  /// light still shows: they do not cancel a bake before any of its light has shown.
  void setLights(std::string unsaved);
  /// Takes lights from their file again, from the next reload on.
  void forgetLights();
  /// Bakes and draws by other options from now on. The current level is baked anew if its light
  /// depends on them; `redrawn` only changes how it is drawn.
  void setOptions(const OptionValues& values);

  /// Bakes the level with its movers at rest at these shares, the first of these first, whenever
  /// nothing else is to be done. Replaces what was wanted before.
  void want(std::span<const std::vector<double>> states);

  /// The oldest news that has not been taken.
  std::optional<LevelNews> news();
  /// The progress of a bake, while one shows.
  std::optional<StageProgress> progress() const;

 private:
  struct Job {
    std::optional<Changed> changed;
    bool hasOtherOptions;
    std::vector<double> atRest;  ///< shares of movers to bake for; without them nothing
    std::stop_token stop;
  };
  void run(const std::stop_token& stopOfFirst);
  void attempt(const std::function<void()>& work);
  std::optional<Job> nextJob();
  void load(Changed changed);
  LoadResult loaded(Changed changed);
  /// Whether there is another job, or the end, before the time is over.
  bool isAskedWithin(std::chrono::milliseconds time);
  bool isOvertaken() const;
  std::optional<std::string> unsavedLights() const;
  void refuse(std::string mistake);
  void light(bool isFirst, const std::stop_token& stop);
  void takeFromFile();
  void lightAtRest(const std::vector<double>& shares, const std::stop_token& stop);
  std::optional<BakedLight> lightOf(const Scene& moved, const std::stop_token& stop);
  std::optional<BakedLight> lightInFile(const Scene& moved, const std::vector<double>& shares);
  std::optional<BakedLight> finish(Rebake& rebake, const std::stop_token& stop);
  bool isAsked() const { return asked_ || areOptionsNew_ || isOver_; }
  OptionValues options() const;
  const DrawnTextures& texturesFor(TextureFilter filter);
  bool showKept(const BakeCache& cache, const BakeSettings& settings);
  std::shared_ptr<const LitLevel> show(BakedLight light, bool isDraft);
  void setProgress(std::shared_ptr<const BakeProgress> progress);
  void tell(LevelNews news);

  const std::chrono::milliseconds nextFile_;

  mutable std::mutex mutex_;  ///< of what follows
  std::condition_variable wakeUp_;
  std::optional<Changed> asked_;
  std::optional<std::string> unsavedLights_;
  bool isOver_ = false;
  OptionValues values_;
  bool areOptionsNew_ = false;              ///< and have not been baked by
  std::stop_source stop_;                   ///< of the job at hand
  bool hasShownDraft_ = false;              ///< of that job
  std::deque<std::vector<double>> wanted_;  ///< states at rest
  std::deque<LevelNews> news_;
  std::shared_ptr<const BakeProgress> progress_;
  double bakeBegin_ = 0;

  // The thread's own:
  std::shared_ptr<const LoadedLevel> current_;
  std::shared_ptr<const LevelSource> source_;  ///< none of a model
  std::optional<ModelFigures> model_;
  bool isOfFiles_ = true;                  ///< the current level; else they have mistakes
  bool isLit_ = false;                     ///< with its own light, not a draft
  std::set<std::vector<double>> missing_;  ///< states that are not in the file of `--light-from`
  BakeSettings litBy_;                     ///< if it is
  std::vector<std::string> mistakes_;      ///< of the files as they were read last
  std::optional<std::string> refusal_;     ///< why the level is not lit
  LightMemory memory_;
  SharedImages images_;  ///< that `textures_` are made of, for this filter
  TextureFilter filter_{};
  DrawnTextures textures_;

  std::jthread thread_;  ///< last, so that it ends first
};

}  // namespace hearth
