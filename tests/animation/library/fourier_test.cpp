#include "animation/library/fourier.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

FourierSeries randomSeries(Generator& generator, int channels, int harmonics) {
  FourierSeries series;
  series.alpha = Eigen::MatrixXd::Zero(channels, harmonics + 1);
  series.beta = series.alpha;
  for (int i = 0; i < channels; ++i) {
    for (int k = 0; k <= harmonics; ++k) {
      series.alpha(i, k) = uniform(generator, -1.0, 1.0);
      if (k > 0) series.beta(i, k) = uniform(generator, -1.0, 1.0);
    }
  }
  return series;
}

Eigen::VectorXd valueOf(const FourierSeries& series, double phase) {
  Eigen::VectorXd value = Eigen::VectorXd::Zero(series.channels());
  for (int k = 0; k <= series.harmonics(); ++k) {
    value += std::cos(2.0 * kPi * k * phase) * series.alpha.col(k) +
             std::sin(2.0 * kPi * k * phase) * series.beta.col(k);
  }
  return value;
}

Eigen::MatrixXd samplesOf(const FourierSeries& series, const std::vector<double>& phases) {
  Eigen::MatrixXd samples(series.channels(), static_cast<Eigen::Index>(phases.size()));
  for (size_t i = 0; i < phases.size(); ++i) samples.col(i) = valueOf(series, phases[i]);
  return samples;
}

TEST(Fourier, ABandLimitedSignalIsRecoveredFromUnevenSamples) {
  Generator generator(41);
  for (const int harmonics : {1, 4, 12}) {
    const FourierSeries series = randomSeries(generator, 5, harmonics);
    std::vector<double> phases;
    const int count = 2 * harmonics + 9;
    for (int i = 0; i < count; ++i) phases.push_back((i + uniform(generator, 0.0, 0.3)) / count);
    const FourierSeries fitted = fitFourier(samplesOf(series, phases), phases, harmonics);
    EXPECT_LT((fitted.alpha - series.alpha).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LT((fitted.beta - series.beta).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(Fourier, WhatIsAboveTheBandIsLeftOutOfEvenSamples) {
  Generator generator(42);
  const FourierSeries series = randomSeries(generator, 3, 9);
  std::vector<double> phases;
  for (int i = 0; i < 40; ++i) phases.push_back(i / 40.0);
  const FourierSeries fitted = fitFourier(samplesOf(series, phases), phases, 5);
  EXPECT_LT((fitted.alpha - series.alpha.leftCols(6)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((fitted.beta - series.beta.leftCols(6)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Fourier, TheBasisIsCosinesAndSinesInterleaved) {
  Generator generator(43);
  std::vector<double> basis(26);
  for (int i = 0; i < 50; ++i) {
    const double phase = uniform(generator, -2.0, 2.0);
    fourierBasis(phase, 12, basis.data());
    for (int k = 0; k <= 12; ++k) {
      EXPECT_NEAR(basis[2 * k], std::cos(2.0 * kPi * k * phase), 1e-13);
      EXPECT_NEAR(basis[2 * k + 1], std::sin(2.0 * kPi * k * phase), 1e-13);
    }
  }
}

TEST(Fourier, ShiftedPhasesTurnTheCoefficientsOnly) {
  Generator generator(44);
  const FourierSeries series = randomSeries(generator, 4, 3);
  std::vector<double> phases, shifted;
  for (int i = 0; i < 16; ++i) {
    phases.push_back(i / 16.0);
    shifted.push_back(i / 16.0 + 0.5);
  }
  const FourierSeries fitted = fitFourier(samplesOf(series, phases), shifted, 3);
  for (const double phase : {0.0, 0.13, 0.77}) {
    EXPECT_LT((valueOf(fitted, phase + 0.5) - valueOf(series, phase)).norm(), 1e-12);
  }
}

TEST(Fourier, AConstantSignalHasAMeanAndNothingElse) {
  const std::vector<double> phases = {0.0, 0.2, 0.4, 0.6, 0.8, 0.9, 0.95};
  const FourierSeries fitted = fitFourier(Eigen::MatrixXd::Constant(2, 7, 3.5), phases, 3);
  EXPECT_LT((fitted.alpha.col(0).array() - 3.5).abs().maxCoeff(), 1e-13);
  EXPECT_LT(fitted.alpha.rightCols(3).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_LT(fitted.beta.cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Fourier, NoHarmonicsIsTheMean) {
  Eigen::MatrixXd samples(1, 4);
  samples << 1.0, 2.0, 3.0, 6.0;
  const FourierSeries fitted = fitFourier(samples, {0.0, 0.25, 0.5, 0.75}, 0);
  EXPECT_EQ(fitted.harmonics(), 0);
  EXPECT_NEAR(fitted.alpha(0, 0), 3.0, 1e-14);
}

}  // namespace
}  // namespace amble
