"""Parameters of a system from what was measured of its motions.

======================  ==========================================================================
`fit`                   `fit`: from measurements to a `Fit`
`fit_record`            `Fit`: estimates, uncertainties, residuals, and what the fitted motion does
`affine_outputs`        affine functions of states, accelerations and forces, read from expressions
`local_maxima`          all local maxima of boundary functions along a motion
`losses`                loss functions of squared residuals
`measurements`          `Experiment`, and the series, event times and steady responses in it
`minimise`              the search from one start or many, and the noise that was not given
`nearest_grazing`       how far a fitted motion stays from grazing
`prediction`            what a motion says of the measurements, with exact derivatives
`response_curves`       fitted steady responses between the measured points
`response_prediction`   what steady responses say of the measurements, with exact derivatives
`response_quantities`   peaks, amplitudes, averages and first harmonics of steady responses
`residuals`             weighted residuals of all experiments and priors
`steady_orbits`         steady responses: found, and followed to other parameters
`statistics`            covariance, intervals, and combinations that no data tell
`table_changes`         how a motion's fields and rows change with parameters
`tables`                columns of numbers from CSV, npz and xarray
`unknowns`              parameters of all experiments, the start and the clock of each
======================  ==========================================================================
"""
