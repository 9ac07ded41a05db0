# A rocking block that chatters, as an engine for chattercheck: reads questions, one JSON object a line, and prints answers.
#
# Between impacts phi'' = phi - side - f(tau), with side the sign of phi and f = cos(omega tau) + r sin(omega tau) the acceleration of the ground
# over that which starts the rocking, r = sqrt(a^2 - 1). At an impact, phi = 0, the velocity is multiplied by eta. Replace what is yours.

# cosh or sinh (sign = 1), cos or sin (sign = -1) from the power x^n on, divided by x^n: 1/n! + sign x^2/(n+2)! + ...
function series(n, x, sign)
    term = total = 1 / factorial(n)
    while abs(term) > 1e-17 * abs(total)
        n += 2
        term *= sign * x * x / (n * (n - 1))
        total += term
    end
    return total
end

# side + f; 1 - cos is written as 2 sin^2, so that nothing is lost next to the start.
pull(side, r, phase) = r * sin(phase) + (side > 0 ? 2cos(phase / 2)^2 : -2sin(phase / 2)^2)

# phi/s and phi' a time s after the impact. No term is the small difference of large ones, so that short flights are as right as long ones.
function flight(s, side, v, omega, r, phase)
    g = pull(side, r, phase)
    h0, h1, h2, h3, h4 = (series(n, s, 1) for n in 0:4)
    b2, b3, b4 = (h + omega^2 * series(n, omega * s, -1) for (n, h) in ((2, h2), (3, h3), (4, h4)))
    f = (cos(phase) + r * sin(phase)) * s^3 * omega^2 / (1 + omega^2)
    slope = (r * cos(phase) - sin(phase)) * s^2 * omega / (1 + omega^2)
    return v * h1 - g * s * h2 + f * b4 - slope * b3, v * h0 - g * s * h1 + f * b3 - slope * b2
end

# The first root of phi up to the time stop, and phi' there: a scan for the change of sign, then Newton's method kept inside of the bracket.
function landing(stop, side, v, omega, r, phase)
    g = pull(side, r, phase)
    step = v * g > 0 ? min(v / g / 2, stop / 64) : stop / 64
    low, high = 0.0, step
    while side * flight(high, side, v, omega, r, phase)[1] > 0
        high >= stop && return nothing
        low, high = high, min(high + max(step, high / 16), stop)
    end
    s, speed = high, 0.0
    for _ in 1:200
        phi, speed = flight(s, side, v, omega, r, phase)
        side * phi > 0 ? (low = s) : (high = s)
        new = s - phi * s / speed
        low < new < high || (new = (low + high) / 2)
        abs(new - s) <= 2e-16 * s && break
        s = new
    end
    return s, speed
end

# The columns of the history of a case, and why it ends; until is nothing for half a period of the ground.
function chatter(epsilon, omega, eta, impacts, until)
    time, interval, velocity = Float64[], Float64[], Float64[]
    epsilon <= 0 && return time, interval, velocity, "never-rocks"
    r, stop = sqrt(epsilon * (2 + epsilon)), something(until, pi / omega)
    now, v, side, before = 0.0, 0.0, -1, 0.0
    while true
        found = landing(stop - now, side, v, omega, r, omega * now)
        if found === nothing || now + found[1] >= stop
            return time, interval, velocity, until === nothing ? "incomplete" : "limit-reached"
        end
        s, v = found[1], eta * found[2]
        now, side = now + s, -side
        push!(time, now), push!(interval, s), push!(velocity, v)
        if abs(v) < 1e-250 || length(time) == impacts
            # The intervals that are left are a geometric series; if the pull hardly changes while they last, the block comes to rest.
            left = (before + s) * eta^2 / (1 - eta^2)
            change = omega * left * abs(r * cos(omega * now) - sin(omega * now))
            weakest = min(pull(1, r, omega * now), -pull(-1, r, omega * now))
            return time, interval, velocity, change < 0.1 * weakest ? "at-rest" : "limit-reached"
        end
        before = s
    end
end

# The text behind "name": in a question, a number or a list; nothing if it is something else. Questions have no spaces, and every name once.
function field(question, name)
    found = match(Regex("\"$name\":(?:\\[([^\\]]*)\\]|([-+0-9.eE]+))"), question)
    return found === nothing ? nothing : something(found[1], found[2])
end

# Julia prints the shortest decimal that is read back as the same double.
list(values) = "[" * join(values, ",") * "]"

function answer(question)
    number(name) = (text = field(question, name); text === nothing ? nothing : parse(Float64, text))
    if occursin("\"cmd\":\"start\"", question)
        # The numbers are read and printed again, which shows that no digit is lost.
        echo = list(parse.(Float64, split(field(question, "echo"), ",")))
        return """{"version":1,"engine":{"name":"my Julia engine","version":"1","language":"Julia"},"models":["linear"],""" *
               """"normalisations":["threshold"],"ground":["sine"],"echo":$echo}"""
    end
    seq, omega, until = field(question, "seq"), number("omega"), number("until")
    if !occursin("\"model\":\"linear\"", question) || something(until, 0.0) * omega > 10
        return """{"seq":$seq,"decline":{"reason":"not the linear block in little more than half a period"}}"""
    end
    time, interval, velocity, ending = chatter(number("epsilon"), omega, number("eta"), number("impacts"), until)
    return """{"seq":$seq,"history":{"time":$(list(time)),"interval":$(list(interval)),"velocity":$(list(velocity)),"ending":"$ending"}}"""
end

for question in eachline(stdin)
    occursin("\"cmd\":\"stop\"", question) && break
    println(answer(question))
    # Flushed, or the gate waits for ever for an answer that stays in a buffer.
    flush(stdout)
end
