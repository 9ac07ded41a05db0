"""What an adapter adds where the simulator only goes from one impact to the next: whether the block comes to rest."""

import math


def closed(case, history):
    """A list that is as long as was asked for comes to rest if its intervals fall as a geometric series and the ground hardly changes while they last."""
    times = history.time
    if history.ending != "limit-reached" or len(times) < max(case.impacts, 3):
        return history
    left = (times[-1] - times[-3]) * case.eta**2 / (1.0 - case.eta**2)
    angle, r = case.omega * times[-1], math.sqrt(case.epsilon * (2.0 + case.epsilon))
    f, slope = math.cos(angle) + r * math.sin(angle), case.omega * (r * math.cos(angle) - math.sin(angle))
    # A tenth: what the pull may change by while the rest of a geometric series runs out, as in the starters of `chattercheck engine new`.
    if left * abs(slope) < 0.1 * min(1.0 + f, 1.0 - f):
        history.ending = "at-rest"
    return history
