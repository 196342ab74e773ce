"""Parameters of a system from what was measured of its motions.

==================  ==============================================================================
`fit`               `fit`: from measurements to a `Fit`
`fit_record`        `Fit`: estimates, uncertainties, residuals, and what the fitted motion does
`affine_outputs`    affine functions of the state, read from expressions
`local_maxima`      all local maxima of boundary functions along a motion
`losses`            loss functions of squared residuals
`measurements`      `Experiment`, and the series of outputs and event times in it
`minimise`          the search from one start or many, and the noise that was not given
`nearest_grazing`   how far a fitted motion stays from grazing
`prediction`        what a motion says of the measurements, with exact derivatives
`residuals`         weighted residuals of all experiments and priors
`statistics`        covariance, intervals, and combinations that no data tell
`tables`            columns of numbers from CSV, npz and xarray
`unknowns`          parameters of all experiments, the start and the clock of each
==================  ==============================================================================
"""
