"""A rocking block that chatters, as an engine for chattercheck: reads questions, one JSON object a line, and prints answers.

Between impacts phi'' = phi - side - f(tau), with side the sign of phi and f = cos(omega tau) + r sin(omega tau) the acceleration of the ground over
that which starts the rocking, r = sqrt(a^2 - 1). At an impact, phi = 0, the velocity is multiplied by eta. Replace what is yours.
"""
import json, math, sys, time


def series(n, x, sign):
    """cosh or sinh (sign = 1), cos or sin (sign = -1) from the power x^n on, divided by x^n: 1/n! + sign x^2/(n+2)! + ..."""
    term = total = 1.0 / math.factorial(n)
    while abs(term) > 1e-17 * abs(total):
        n += 2
        term *= sign * x * x / (n * (n - 1))
        total += term
    return total


def flight(s, side, v, omega, r, phase):
    """phi/s and phi' a time s after the impact. No term is the small difference of large ones, so that short flights are as right as long ones."""
    f = math.cos(phase) + r * math.sin(phase)
    slope = r * math.cos(phase) - math.sin(phase)
    h = [series(n, s, 1) for n in range(5)]
    t = [series(n, omega * s, -1) for n in range(5)]
    b = [h[n] + omega**2 * t[n] for n in range(5)]
    f, slope = f * s**3 * omega**2 / (1 + omega**2), slope * s**2 * omega / (1 + omega**2)
    g = pull(side, r, phase)
    return v * h[1] - g * s * h[2] + f * b[4] - slope * b[3], v * h[0] - g * s * h[1] + f * b[3] - slope * b[2]


def pull(side, r, phase):
    """side + f; 1 - cos is written as 2 sin^2, so that nothing is lost next to the start."""
    return r * math.sin(phase) + (2 * math.cos(phase / 2) ** 2 if side > 0 else -2 * math.sin(phase / 2) ** 2)


def landing(end, side, v, omega, r, phase):
    """The first root of phi up to the time end, and phi' there: a scan for the change of sign, then Newton's method kept inside of the bracket."""
    g = pull(side, r, phase)
    step = min(v / g / 2 if v * g > 0 else end, end / 64)
    low, high = 0.0, step
    while side * flight(high, side, v, omega, r, phase)[0] > 0:
        if high >= end:
            return None
        low, high = high, min(high + max(step, high / 16), end)
    s = high
    for _ in range(200):
        phi, speed = flight(s, side, v, omega, r, phase)
        low, high = (s, high) if side * phi > 0 else (low, s)
        new = s - phi * s / speed if speed else low
        new = new if low < new < high else (low + high) / 2
        if abs(new - s) <= 2e-16 * s:
            break
        s = new
    return s, speed


def chatter(case):
    """The columns of the history of a case."""
    epsilon, omega, eta = case["epsilon"], case["omega"], case["eta"]
    end = math.pi / omega if case["until"] == "half-period" else case["until"]
    history = {"time": [], "interval": [], "velocity": [], "ending": "never-rocks"}
    if epsilon <= 0:
        return history
    r = math.sqrt(epsilon * (2 + epsilon))
    now, v, side, interval, before = 0.0, 0.0, -1, 0.0, 0.0
    while True:
        found = landing(end - now, side, v, omega, r, omega * now)
        if found is None or now + found[0] >= end:
            history["ending"] = "incomplete" if case["until"] == "half-period" else "limit-reached"
            return history
        before, interval, v = interval, found[0], eta * found[1]
        now, side = now + interval, -side
        history["time"].append(now)
        history["interval"].append(interval)
        history["velocity"].append(v)
        if abs(v) < 1e-250 or len(history["time"]) == case["impacts"]:
            # The intervals that are left are a geometric series; if the pull hardly changes while they last, the block comes to rest.
            left = (before + interval) * eta**2 / (1 - eta**2)
            change = omega * left * abs(r * math.cos(omega * now) - math.sin(omega * now))
            weakest = min(pull(1, r, omega * now), -pull(-1, r, omega * now))
            history["ending"] = "at-rest" if change < 0.1 * weakest else "limit-reached"
            return history


def answer(case):
    """The answer to a case."""
    if case["model"] != "linear" or "sine" not in case["ground"]:
        return {"decline": {"reason": "another model", "why": "this engine has the linear block under a sinusoid"}}
    if case["until"] != "half-period" and case["until"] * case["omega"] > 10:
        return {"decline": {"reason": "too long", "why": "the power series are for little more than half a period"}}
    try:
        began = time.perf_counter_ns()
        return {"history": chatter(case), "ns": time.perf_counter_ns() - began}
    except ArithmeticError as error:
        return {"error": {"message": repr(error)}}


for line in sys.stdin:
    question = json.loads(line)
    if question["cmd"] == "start":
        reply = {"version": 1, "engine": {"name": "my python engine", "version": "1", "language": "Python"}, "models": ["linear"],
                 "normalisations": ["threshold"], "ground": ["sine"], "echo": question["echo"]}
    elif question["cmd"] == "case":
        reply = {"seq": question["seq"], **answer(question)}
    else:
        break
    # Flushed, or the gate waits for ever for an answer that stays in a buffer.
    print(json.dumps(reply, allow_nan=False), flush=True)
