% A rocking block that chatters, as an engine for chattercheck: reads questions, one JSON object a line, and prints answers.
%
% Between impacts phi'' = phi - side - f(tau), with side the sign of phi and f = cos(omega tau) + r sin(omega tau) the acceleration of the ground
% over that which starts the rocking, r = sqrt(a^2 - 1). At an impact, phi = 0, the velocity is multiplied by eta. Replace what is yours.
1;

% For n = 0 to 4: cosh or sinh (sign = 1), cos or sin (sign = -1) from the power x^n on, divided by x^n: 1/n! + sign x^2/(n+2)! + ...
% All terms at once, as loops are slow; there are enough of them for x up to 50.
function totals = series (x, sign)
  persistent k = (0:83)';
  persistent factorials = factorial ((0:4) + 2 * (0:83)');
  totals = sum ((sign * x * x) .^ k ./ factorials);
end

% side + f; 1 - cos is written as 2 sin^2, so that nothing is lost next to the start.
function g = pull (side, r, phase)
  if side > 0
    g = r * sin (phase) + 2 * cos (phase / 2) ^ 2;
  else
    g = r * sin (phase) - 2 * sin (phase / 2) ^ 2;
  end
end

% phi/s and phi' a time s after the impact. No term is the small difference of large ones, so that short flights are as right as long ones.
function [phi, speed] = flight (s, side, v, omega, r, phase)
  g = pull (side, r, phase);
  h = series (s, 1);
  b = h + omega ^ 2 * series (omega * s, -1);
  f = (cos (phase) + r * sin (phase)) * s ^ 3 * omega ^ 2 / (1 + omega ^ 2);
  slope = (r * cos (phase) - sin (phase)) * s ^ 2 * omega / (1 + omega ^ 2);
  phi = v * h(2) - g * s * h(3) + f * b(5) - slope * b(4);
  speed = v * h(1) - g * s * h(2) + f * b(4) - slope * b(3);
end

% The first root of phi up to the time stop, or [], and phi' there: a scan for the change of sign, then Newton's method kept inside of the bracket.
function [s, speed] = landing (stop, side, v, omega, r, phase)
  % A block that has not come back after so long, exp (50), never will.
  stop = min (stop, 50);
  g = pull (side, r, phase);
  step = stop / 64;
  if v * g > 0
    step = min (v / g / 2, step);
  end
  low = 0;
  high = step;
  speed = 0;
  while side * flight (high, side, v, omega, r, phase) > 0
    if high >= stop
      s = [];
      return
    end
    low = high;
    high = min (high + max (step, high / 16), stop);
  end
  s = high;
  for n = 1:200
    [phi, speed] = flight (s, side, v, omega, r, phase);
    if side * phi > 0
      low = s;
    else
      high = s;
    end
    new = s - phi * s / speed;
    if ! (low < new && new < high)
      new = (low + high) / 2;
    end
    if abs (new - s) <= 2e-16 * s
      return
    end
    s = new;
  end
end

% The columns of the history of a case, and why it ends; longest is NaN for half a period of the ground.
function [time, interval, velocity, ending] = chatter (epsilon, omega, eta, impacts, longest)
  time = interval = velocity = [];
  ending = "never-rocks";
  if epsilon <= 0
    return
  end
  r = sqrt (epsilon * (2 + epsilon));
  stop = longest;
  if isnan (longest)
    stop = pi / omega;
  end
  now = v = before = 0;
  side = -1;
  while true
    [s, speed] = landing (stop - now, side, v, omega, r, omega * now);
    if isempty (s) || now + s >= stop
      ending = "limit-reached";
      if isnan (longest)
        ending = "incomplete";
      end
      return
    end
    v = eta * speed;
    now += s;
    side = -side;
    time(end + 1) = now;
    interval(end + 1) = s;
    velocity(end + 1) = v;
    if abs (v) < 1e-250 || numel (time) == impacts
      % The intervals that are left are a geometric series; if the pull hardly changes while they last, the block comes to rest.
      left = (before + s) * eta ^ 2 / (1 - eta ^ 2);
      change = omega * left * abs (r * cos (omega * now) - sin (omega * now));
      weakest = min (pull (1, r, omega * now), -pull (-1, r, omega * now));
      ending = "limit-reached";
      if change < 0.1 * weakest
        ending = "at-rest";
      end
      return
    end
    before = s;
  end
end

% The numbers behind "name": in a question, one or a list; NaN if it is something else. Questions have no spaces, and every name once.
function values = numbers (question, name)
  found = regexp (question, ["\"" name "\":\\[?([-+0-9.eE,]+)"], "tokens", "once");
  values = NaN;
  if ! isempty (found)
    values = str2double (strsplit (regexprep (found{1}, ",$", ""), ","));
  end
end

% With 17 significant digits, which are read back as the same double.
function text = list (values)
  text = ["[" strjoin(arrayfun (@(value) sprintf ("%.17g", value), values, "UniformOutput", false), ",") "]"];
end

function text = answer (question)
  has = @(words) ! isempty (strfind (question, words));
  if has ("\"cmd\":\"start\"")
    % The numbers are read and printed again, which shows that no digit is lost.
    text = ["{\"version\":1,\"engine\":{\"name\":\"my Octave engine\",\"version\":\"1\",\"language\":\"Octave\"},\"models\":[\"linear\"]," ...
            "\"normalisations\":[\"threshold\"],\"ground\":[\"sine\"],\"echo\":" list(numbers (question, "echo")) "}"];
    return
  end
  seq = sprintf ("{\"seq\":%d,", numbers (question, "seq"));
  omega = numbers (question, "omega");
  longest = numbers (question, "until");
  if ! has ("\"model\":\"linear\"") || longest * omega > 10
    text = [seq "\"decline\":{\"reason\":\"not the linear block in little more than half a period\"}}"];
    return
  end
  [time, interval, velocity, ending] = chatter (numbers (question, "epsilon"), omega, numbers (question, "eta"), numbers (question, "impacts"), longest);
  text = [seq "\"history\":{\"time\":" list(time) ",\"interval\":" list(interval) ",\"velocity\":" list(velocity) ",\"ending\":\"" ending "\"}}"];
end

while true
  % Not by fgetl, which waits for the first letter of the next line.
  question = input ("", "s");
  if ! isempty (strfind (question, "\"cmd\":\"stop\""))
    break
  end
  printf ("%s\n", answer (question));
  % Flushed, or the gate waits for ever for an answer that stays in a buffer.
  fflush (stdout);
end
