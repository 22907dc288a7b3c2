// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef vpServoing_h
#define vpServoing_h

#include <visp3/core/vpColVector.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpMatrix.h>
#include <visp3/core/vpRobust.h>

BEGIN_VISP_NAMESPACE

//! ViSP's own steps of a virtual visual servoing and what they work on, which vpMbTracker keeps to itself and to those
//! who derive from it.
class vpServoing
{
public:
  virtual ~vpServoing() = default;

  //! The pose that is estimated; nobody else may change it meanwhile.
  virtual vpHomogeneousMatrix &pose() = 0;
  virtual vpColVector &error() = 0;
  virtual vpColVector &weights() = 0;
  virtual vpMatrix &interaction() = 0;
  //! Motions that the user chose to be estimated, see vpMbTracker::setEstimatedDoF().
  virtual vpMatrix &chosenMotions() = 0;
  virtual bool areAllChosen() const = 0;
  virtual unsigned int mostIterations() const = 0;
  virtual double convergence() const = 0;
  virtual double firstDamping() const = 0;

  //! What users may override: computeVVSInit() and so on.
  virtual void init() = 0;
  virtual void evaluate() = 0;
  virtual void weigh(vpRobust &robust, const vpColVector &error, vpColVector &w) = 0;

  //! Memory of the iterations.
  struct Step
  {
    vpColVector weightedError;
    vpColVector errorBefore;
    vpMatrix LTL;
    vpColVector LTR;
    vpColVector velocity;
    double damping = 0.; //!< Of Levenberg and Marquardt.
    vpHomogeneousMatrix cMoBefore;
  };
  virtual bool mustRestart(unsigned int iteration, Step &step) = 0;
  virtual void solve(bool allMotions, unsigned int iteration, Step &step) = 0;
};

END_VISP_NAMESPACE
#endif
