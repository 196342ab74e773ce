"""What is measured along a simulated motion.

=============  ==============================================================
`phases`       a motion, phase by phase, in closed form
`extremes`     guaranteed peaks
`observables`  peaks, averages, times in configurations, contact forces
`tangent`      derivatives of a motion by its start
`lyapunov`     Lyapunov exponents and their errors
=============  ==============================================================
"""
