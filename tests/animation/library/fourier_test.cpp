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

// Parseval: the mean square over a period is that of the mean and half of each wave's.
TEST(Fourier, TheMeanSquareIsThatOfItsWaves) {
  Generator generator(46);
  for (const int harmonics : {1, 5, 12}) {
    const FourierSeries series = randomSeries(generator, 4, harmonics);
    constexpr int kTimes = 64;  // more than twice the harmonics: the mean is exact
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(4);
    for (int i = 0; i < kTimes; ++i)
      squares += fourierAt(series, static_cast<double>(i) / kTimes).cwiseAbs2() / kTimes;
    Eigen::VectorXd wanted = series.alpha.col(0).cwiseAbs2();
    for (int k = 1; k <= harmonics; ++k)
      wanted += 0.5 * (series.alpha.col(k).cwiseAbs2() + series.beta.col(k).cwiseAbs2());
    EXPECT_LT((squares - wanted).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(Fourier, TheSlopeIsTheSeriesOfTurnedWaves) {
  Generator generator(47);
  const FourierSeries series = randomSeries(generator, 3, 6);
  FourierSeries slope = series;
  for (int k = 0; k <= 6; ++k) {
    slope.alpha.col(k) = 2.0 * kPi * k * series.beta.col(k);
    slope.beta.col(k) = -2.0 * kPi * k * series.alpha.col(k);
  }
  constexpr double kStep = 1e-6;
  for (double phase = 0.0; phase < 1.0; phase += 0.07) {
    const Eigen::VectorXd measured =
        (fourierAt(series, phase + kStep) - fourierAt(series, phase - kStep)) / (2.0 * kStep);
    EXPECT_LT((measured - fourierAt(slope, phase)).cwiseAbs().maxCoeff(), 1e-6);
  }
}

// Least squares: what is left over has none of the waves that were fitted.
TEST(Fourier, WhatAFitLeavesOverHasNoneOfItsWaves) {
  Generator generator(48);
  std::vector<double> phases;
  for (int i = 0; i < 50; ++i) phases.push_back(uniform(generator, 0.0, 1.0));
  Eigen::MatrixXd samples(3, 50);
  for (Eigen::Index i = 0; i < samples.size(); ++i) samples(i) = uniform(generator, -1.0, 1.0);
  const FourierSeries fitted = fitFourier(samples, phases, 4);
  const Eigen::MatrixXd left = samples - samplesOf(fitted, phases);
  for (int k = 0; k <= 4; ++k) {
    Eigen::VectorXd cosine = Eigen::VectorXd::Zero(3), sine = cosine;
    for (int i = 0; i < 50; ++i) {
      cosine += std::cos(2.0 * kPi * k * phases[i]) * left.col(i);
      sine += std::sin(2.0 * kPi * k * phases[i]) * left.col(i);
    }
    EXPECT_LT(cosine.cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LT(sine.cwiseAbs().maxCoeff(), 1e-10);
  }
}

}  // namespace
}  // namespace amble
