#include "lint/lint.h"

namespace hearth {

std::vector<Diagnostic> lintGeometry(const LintedLevel& linted) {
  Findings findings;
  findOneWayPortals(linted, findings);
  findUnreachable(linted, findings);
  findNearMisses(linted, findings);
  findTextureJumps(linted, findings);
  findUnseenTextures(linted, findings);
  findUnseenThings(linted, findings);
  findImpassable(linted, findings);
  findMisplacedPlayer(linted, findings);
  findIdleMovers(linted, findings);
  findShutIn(linted, findings);
  return findings.resolve(linted.source.documents);
}

std::vector<Diagnostic> lintLight(const LintedLevel& linted, const BakedLight& light,
                                  const BakedLight& dimmed, const BakeSettings& settings,
                                  int threads) {
  Findings findings;
  findUselessLights(linted, settings, threads, findings);
  findBlack(linted, light, findings);
  findOverexposed(linted, dimmed, findings);
  return findings.resolve(linted.source.documents);
}

}  // namespace hearth
