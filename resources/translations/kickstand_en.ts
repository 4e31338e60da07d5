<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US">
<context>
    <name>Charts</name>
    <message>
        <source>mutiny (paired)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the own boat&apos;s Result names this COACH</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>5 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other COACH, or silence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result names this COACH</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mutiny, or morale −10</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>morale above −10, or 3 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>5 s without Update Morale, or Jettison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paired, stands still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assertion of Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>5 s without velocity, or Jettison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>morale −10</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suppress Mutiny: morale −5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3 s without Suppress Mutiny, 5 s without velocity, or Jettison</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Check</name>
    <message>
        <source>wheel 1, front left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheel 2, back left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheel 3, back right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheel 4, front right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the dribbler&apos;s motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LEDs: all four on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LEDs: Hall sensors of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LEDs: encoder lines of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LEDs: encoder count of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LEDs: charger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Are all four LEDs lit?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn %1 by hand: do LEDs 0 to 2 change, and is never all or none of them lit?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn %1 by hand: do LEDs 0 and 1 change by turns?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn %1 by hand: do the four LEDs count?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Did LED 0 blink while the capacitor was charged, and did LED 1 stay dark?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot stands free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dribbler, temperature after running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery under load, sag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Capacitor, time to charged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kick, drop of the capacitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Capacitor after discharge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>skipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Did the dribbler turn?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The capacitor is emptied first…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 runs…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The dribbler runs…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything runs, to load the battery…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The capacitor charges: look at LED 0 and LED 1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kicks, and measures the capacitor…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The capacitor is emptied…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery, at least</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sag under load, at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dribbler, at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charge time, at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop by a kick, at least</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheels run for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kick&apos;s pulse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 is not through yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The check of robot %1 was not finished.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 failed nothing, but not all was checked: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 did not pass: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Did %1, turn smoothly the way that takes the robot %2, and did the four LEDs count?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Does robot %1 stand on its stand, its wheels free, no hand near, no ball at its kicker?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 passed its %2 steps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passed: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not passed: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dribbler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charge and kick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>test LEDs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Not checked: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The check was ended early: %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CheckReport</name>
    <message>
        <source>Bench check of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These are no limits: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no JSON object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no limit “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has to be a number from %2 to %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ChecksReport</name>
    <message>
        <source>Save report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As a page (HTML)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As PDF…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As JSON…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As text…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CoachView</name>
    <message>
        <source>COACH and TOWRP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COACH</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TOWRP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated COACH radio, three boats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start with simulated boats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The XBee adapter of COACH 5, and boats of teams 3, 5 and 7.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated TOWRP radio, a COACH</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Be a simulated boat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The XBee adapter of TOWRP 5, and a COACH that drives it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated XBee</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>XBee</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COACH %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TOWRP %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 not acknowledged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 damaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>virtual boats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>virtual radios, here %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Morale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radio loss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>USB plug</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radio module</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 foreign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radio loss of a boat</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CoachWords</name>
    <message>
        <source>connected: a radio module answers, its address is %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the port is open, but no radio module in API mode answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disconnected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>link lost: a boat that was driven stops by its own timer, within a second of its last velocity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>link failed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the radio module has started anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waiting for the serial port to be plugged in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radio module found, at %1 baud</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no radio module was found at any speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radio module set and read back: %1 (%2), changes: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the radio module could not be set: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COACH %1 starts up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TOWRP %1 wakes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no COACH or TOWRP is played any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TOWRP %1 is heard, with %2 dBm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TOWRP %1 obeys COACH %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TOWRP %1 does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paired with team %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not paired with team %1 any more: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mutiny: three seconds to suppress it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mutiny quelled, morale %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mutiny was not suppressed in time: the crew has the boat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suppress Mutiny sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crew jettisoned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>free digital</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>free analog: %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>morale %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no velocity for a second: the boat stops by itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zero velocity sent to TOWRP %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waiting for the port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>opening the port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>asking the radio module</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no radio module in API mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>setting up the radio module</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radio module ready</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>startup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not paired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>asserting command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mutiny</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>startup ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ask again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>velocity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat velocity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat suppress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mutiny wins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>available</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>morale may change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing was heard for five seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the crew was jettisoned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mutiny was not suppressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ended here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the link was lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>transparent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API mode 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>API mode 2 (escaped)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>acknowledged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no acknowledgement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>channel busy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>purged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>status %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>backward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>counterclockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suppress Mutiny</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assertion of Command, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jettison the Crew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free Digital</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free Analog: %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mutiny in Progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I Am Available</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Assertion of Command Result: COACH %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update Morale: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COACH %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TOWRP %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on its way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sent</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DeviceCards</name>
    <message>
        <source>10.5 to 12 V is safe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>alarm: unsafe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>safe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cell %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>calibrated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>apart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dial %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no tape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tape at the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tape at the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tape in the middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P %1 I %2 D %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>current</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> of %1 A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 turns/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>duty cycle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ticks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ticks/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>its parameters are being found out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>servo %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing near the reader</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0x%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LED %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blue and yellow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yellow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 of 4 lit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off (%1 chosen)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>deadband</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>DeviceWords</name>
    <message>
        <source>unexpected packet delimiter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wrong checksum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>generic error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>serial port found: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>serial port gone: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nobody answers at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the user&apos;s catalogue cannot be read, so it is left out: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>quiet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>asking who is there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nobody answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pending</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changed by the device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sent, unconfirmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>found: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>back: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing comes from it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it began anew; its updates were asked for again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sends no updates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sends updates every %1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was changed to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disabled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it reports: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its data do not fit its kind: %1 bytes came where %2 were expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped and disabled: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The catalogue of your own boards is left out: %1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the file right, or take it away; what it has to be stands in the help.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grants no updates, though it was asked %1 times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sent an update</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Doctor</name>
    <message>
        <source>%1 is plugged in at %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This user may open the device at %1, without a udev rule.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This user may open the device at %1; the udev rule is %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The udev rule is there (%1).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unplug the device and plug it in again. Over ssh you must be a member of plugdev, and log in again after:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No other program holds the device at %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device at %1 is held by %2 (process %3).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close that program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close that program; it belongs to somebody else, so only root can see which one it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cabled robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dongle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>simulated %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 runs: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not run yet: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait a moment; plug the device in if it is not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP is not latched.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything is stopped: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the robots, then re-arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A cable needs none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The dongle&apos;s radios: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unplug the dongle and plug it in again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The dongle&apos;s radios run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The dongle&apos;s radios run on channels %1 and %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The emergency stop is at “run”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The emergency stop: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heard: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot is heard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch one on; check that its battery is full and that its channels are the dongle&apos;s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every robot that is heard sends its readings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No readings come from %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait a moment and look again; if it stays so, switch it off and on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No battery is low.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The battery is low: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change it soon.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing on the link is damaged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Damaged or refused on the link: unreadable %1, stalls %2, reported by the dongle %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A few of them do no harm; the events show each.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not looked at: something before it is wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 with Qt %3 works.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Permission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other programs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radios</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Batteries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Traffic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ok</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robots %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a serial port %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This user may open the serial port %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No other program holds the serial port %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The port is open, and no NXT answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the NXT on, and check that this port is the one of its Bluetooth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No board answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug one in; one that starts takes some seconds. If it stays so, its firmware speaks another protocol.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The NXT answers, and a program runs on it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A radio module in API mode answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boards that answer: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Catalogue</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>Something failed that this program has no words for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{subject} is not right: {detail}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check what was entered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{subject}[ of robot {robot}] is not right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was asked for makes no sense[: {detail}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{subject}[ of robot {robot}] is {got}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a value from {lowest} to {highest}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{subject}[ of robot {robot}] is out of range[: {detail}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A value is out of range[: {got}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one within its range[: {lowest} to {highest}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no “{subject}” here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is: {detail}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That name is not known here[: {subject}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check its spelling.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“{subject}” is not a link: “{detail}”, from character {place} on, cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A link looks like usb:, usb:?port=1-2.3 or sim:thunderbots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“{subject}” is not a link that can be opened here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accepted: {detail}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That is not a link that can be opened here[: {subject}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“{subject}” is not possible here[: {detail}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The help says what is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That is not possible here[: {detail}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pulse of {subject} would end after {got} µs, and {highest} µs is the latest there is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shorten the pulse or the offset.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A kick[ of robot {robot}] without any pulse does not exist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give at least one of the two pulses a width.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{subject} is {got}, which cannot be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has to be {lowest} to {highest}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“{detail}”, from character {place} on, is not {subject}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{subject} cannot be read[: {detail}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check where it comes from.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes came that cannot be read[ (endpoint {endpoint})][: {detail}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that the device is what it says it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no device at {subject}: {detail}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No dongle or cabled robot is plugged in[ ({subject})].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug one in, or try a simulated one: sim:thunderbots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Several devices are plugged in, and any of them could be meant[: {detail}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name one by its place on the bus, as in usb:?port=1-2.3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The dongle is there[ ({subject})], but this user may not open it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Install the udev rule:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The dongle is there[ ({subject})], but another program holds it[: {detail}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close that program; `kickstandctl doctor` says which one it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device is gone: unplugged, or without power[ ({subject})].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug it in again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device keeps refusing[ {subject}][ on endpoint {endpoint}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unplug it and plug it in again; if that does not help, its firmware is not what is expected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer came in time from robot {robot}[ ({subject})].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that it is switched on and near, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer came in time[: {subject}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again; if it stays so, unplug the device and plug it in again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was broken off before it was done[ ({subject})].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start it again if it is still wanted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The operating system reports a failure[ of {subject}][: {detail}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unplug the device and plug it in again, into another socket if there is one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radio {got} of the dongle does not start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unplug the dongle and plug it in again; if it stays so, look at that radio module&apos;s seat.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The dongle&apos;s radios do not start[: {subject}][: {detail}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unplug the dongle and plug it in again; if it stays so, look at the radio modules&apos; seats.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The dongle does not change its channels while its radios run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disconnect, connect again, and set them then.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No link is running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything is stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re-arm first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The high voltage of robot {robot} is not armed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The high voltage is not armed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot {robot} is not heard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch it on, and check its number, its channels and its battery.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is not heard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The emergency stop is not at “run”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that its switch is plugged into the dongle, and turn it to “run”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The kick before[ for robot {robot}] has not been given to the dongle yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait a moment, then kick again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The kick[ for robot {robot}] was dropped: the dongle did not take it within 200 ms.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kick again; if it happens often, the radio is overloaded or disturbed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This input has been held since before[ robot {robot} could be driven].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let it go back to zero once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The capacitor[ of robot {robot}] does not empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Treat it as live, switch the robot off and let it stand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot {robot} has not sent its readings, so its voltage is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Treat it as live, and wait until it reports.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot has not sent its readings, so its voltage is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A check[ of robot {robot}] is running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for its end, or stop it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A sweep[ of robot {robot}] is running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the charger and the battery, or give it longer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too much is waiting already[ ({subject})].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait a moment, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The program was too busy to watch over the robots, so they were braked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re-arm, and close what keeps the computer busy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot {robot} is still busy with what it was asked before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait until it has answered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is still busy with what it was asked before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot[ {robot}] answers, but not to this[: {subject}][, asked {got} times].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again; if it stays so, its firmware does not know this request.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot[ {robot}] is not at rest[: {subject} is on].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brake it, and switch its dribbler, charger and autokick off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The capacitor[ of robot {robot}] is at {got} V[, and has to be below {highest} V].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discharge it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The capacitor[ of robot {robot}] is charged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The battery[ of robot {robot}] is at {got} V, too low to be sure of reaching the end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charge or change it; or allow a low battery if it cannot be helped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The battery[ of robot {robot}] is low.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot[ {robot}] has parameters that were applied and not committed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commit them, or reboot the robot to give them up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The parameters[ of robot {robot}] have not been read yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read them first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firmware is being sent to the robot[ {robot}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait for the end of the upload, or cancel it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No firmware is being sent to the robot[ {robot}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the upload first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot[ {robot}] has exactly this firmware already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing needs to be done; force it to send it all the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the robot[ {robot}] has in its flash is not what was sent[, from address {got} on].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the upload again; if it stays so, the flash memory is worn or broken.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot[ {robot}] runs, but its signature is {got} where {highest} was expected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the upload again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot[ {robot}] runs, but not with the firmware that was sent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no serial port {port}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug the device in, or check the port&apos;s name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See that it is plugged in there and that its server runs (kickstand-sim, or usbipd on that machine), or check the address.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This user may not open the serial port {port}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Join the group that may, then log in again:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program holds the serial port {port}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close that program: a serial monitor, an IDE, or another bench.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device at {subject} is in use: {detail} (USB/IP status {got}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the program that has it, here or on another machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The serial port {port} is gone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug the device in again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The serial port {port} does not work[: {detail}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unplug the device and plug it in again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{detail} did not take {subject}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the value, and whether the board is disabled or out of order.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device did not take it[: {subject}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot[ {robot}] has a number or channels that it does not use before its next reboot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reboot it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step {place}, “{subject}”, has no code that the robot knows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write in its place: {detail}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The movement[ “{subject}”] has no code.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a distance or an angle from the tables.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot refused: {detail} (error {got}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Query the slot to see what is in it, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot refused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sent, because the robot would refuse it: {detail} (error {got}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose an empty slot to create, or the ID of the plan in it to update or execute.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not sent, because the robot would refuse it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Query the slot to see what is in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A plan is executing already, or may be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot confirmed something else than was sent[ ({subject})][: {detail}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send it again; if what is missing begins at a zero byte, the robot&apos;s program reads its mailbox as text.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the robot: if it does not do it, ask again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The NXT answers that {detail} (status {got}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start the robot&apos;s program on it, then try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The NXT refuses to answer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No boat and COACH are paired.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pair them first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The boat[ of team {robot}] obeys another COACH[: that of team {got}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait until it says that it is available again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This program plays a COACH or a TOWRP at present.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End that role first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No radio module in API mode answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look for it and set it up: with `kickstandctl coach radio set`.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The radio module is not set up[ for {subject}][: its address is {detail}].</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply the preset for it: with `kickstandctl coach radio set`.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The radio module says something else than what it was set to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read it again, and set what is still wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{subject} is out of range: {detail}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a value within its range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Execute a plan first, and adjust it before it ends.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing needs to be stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its program takes updates only while a plan executes: execute one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing came back that says whether it arrived ({subject}), and it is not sent again unasked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot has not confirmed that it stands, though it was told several times.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the robot: if it moves, stop it by hand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing came back that says whether it arrived[ ({subject})], though it was sent several times.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask what is there now, then send it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the robot: if it stands, stop the plan to be sure, and execute it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TOWRP {got} is not heard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch it on, and check that both radio modules have the same channel and network.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It arrived, and nothing came back that says whether the robot obeys (adjust); it is not sent again unasked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The capacitor[ of robot {robot}] was not full in time.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>EventWords</name>
    <message>
        <source>%1 V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connected, all robots told to brake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disconnected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>link lost: the device was unplugged or is without power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>link lost: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>link failed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waiting for a device to be plugged in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>emergency stop: %1, before: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radios: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radio channels: %1 and %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost with %1 on its capacitor: treat as live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>battery at its end: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>battery low: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>test LEDs: normal lights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>test LEDs: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>test LEDs: %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>experiment data: %1 of 256 bytes known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheel limit ±%1, before: ±%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kick given to the dongle: %1 / %2 µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, solenoid 2 later by %1 µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, solenoid 1 later by %1 µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>discharged to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>discharge broken off at %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; treat as live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kick measured: capacitor %1 → %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, charged again in %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>check begun, number of robots: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>checked: %1, steps that did not pass: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>check done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>check ended early: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sweep done, kicks given: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sweep ended early, kicks given: %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>capacitor charged: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kick dropped: the dongle did not take it within 200 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kick dropped: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sweep begun, kicks to give: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>autokick fired, number %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>autokick armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>autokick disarmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charger on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charger off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>high voltage armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>high voltage disarmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>discharging from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the dongle reports: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the dongle says: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unreadable data on endpoint %1, number of times %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>endpoint %1 stalled, in a row: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>something that this program has no words for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>answers to commands that nobody fetched in time and that are lost: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>session opened: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>session closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>re-armed: what was stopped can move again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>checked: passed every step that was chosen</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Experiment</name>
    <message>
        <source>%1 of 256 bytes, messages: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; missing: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Fault</name>
    <message>
        <source>Unknown fault code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown fault code %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radio %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Capacitor charge timed out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chicker board does not communicate properly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chicker board missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FPGA clock manager failed to lock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FPGA fabric failed its online CRC</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FPGA does not communicate properly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FPGA has no bitstream</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FPGA configuration failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Oscillator stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hall sensors read 000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hall sensors read 111</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hall sensors stuck while the encoder moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Encoder stuck while the Hall sensors move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dribbler overheated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dribbler thermistor out of range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radio protocol error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial framing error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hardware overrun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Software overrun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Received packet with a wrong checksum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Received length with a nonzero high byte</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Received length with an illegal low byte</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Local modem did not respond in time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dongle sent a micropacket of the wrong length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dongle sent a message to a pipe that does not exist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SPI flash does not communicate properly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Operational parameters absent or corrupt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Modem did not respond in time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Modem responded to another AT command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AT command failed for an unknown reason</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Modem does not know an AT command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Modem refused the parameter of an AT command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RTS could not be enabled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firmware version could not be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Node identifier could not be set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channel could not be set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PAN identifier could not be set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address could not be set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outbound micropacket overflow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outbound micropacket to no pipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outbound micropacket of the wrong length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Debug text overflow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error queue overflow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Message could not be sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inbound micropacket overflow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inbound micropacket to no pipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inbound micropacket of the wrong length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>USB bit stuffing error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>USB bus turnaround timed out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>USB data field is not whole bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>USB CRC16 error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>USB CRC5 error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>USB packet identifier error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>USB stall</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FlashWizard</name>
    <message>
        <source>Robot %1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 on its capacitor: discharge it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last %1 on its capacitor, not measured any more: treat as live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its wheels run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its dribbler runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its charger is on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>autokick is armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a kick sweep runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is being checked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its high voltage is armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is being asked something: a moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the FPGA&apos;s bitstream</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the microcontroller&apos;s firmware</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Review</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not heard: switch it on, or leave it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an upload to it is running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>discharging, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>battery at %1, too low: change it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dribbler off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charger off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Autokick off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm and discharge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link does not run: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything is stopped: re-arm first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick the robots that are to be flashed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is being read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both files are for %1: remove one, or change its target.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robots are being asked for their signatures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 did not tell what it has. Read again, or go back and leave it out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every robot has it already: there is nothing to do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stay near: the upload runs on when this panel is closed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · part %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · made %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bytes of data · %2 of %3 pages are sent, the others are blank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1–%2 is left out: the robot keeps its own configuration there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>signature of the flash %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>signature of the firmware %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It cannot be read: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing in it but erased bytes: nothing would be sent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Microcontroller firmware takes the place of the FPGA&apos;s bitstream in the robot&apos;s one flash. The robot will not drive until the FPGA&apos;s bitstream is uploaded again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The microcontroller&apos;s firmware is sent first, then the FPGA&apos;s bitstream: the other way round the second would erase the first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>being read…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: has %2, gets %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flash</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>microcontroller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>already there: leave it out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>firmware already there: only the FPGA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the flash is erased (8 s), %2 pages are written, then every block is verified.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only then the bitstream is named as valid, and the robot reboots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only then the firmware is named as valid; the robot reboots, copies it (5 s) and reboots again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its signatures are read and compared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beginning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not begun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connection closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paused while %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 KiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 KiB/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>attempt %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The upload to robot %1 has not begun yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The upload to robot %1 was not begun. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The connection was closed during the upload to robot %1. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: pages %2, signatures %3 (firmware), %4 (flash)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its capacitor was never measured: treat as live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameters were applied and not committed: an upload would make some of them permanent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each robot&apos;s parameters are read; it is marked as having no data, so that it never starts half an image.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FlashWords</name>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>begun: signature %1, pages to send: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot says that its flash has: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>marked as having no data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pages that are still missing: %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>something else is at %1: it has to be erased</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>erasing, attempt %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>erased in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pages written: %1, in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>page %1 was not taken: attempt %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bytes verified: %1, in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>committed: its flash has %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>told to reboot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>back after %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has still to copy the image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>signatures: microcontroller %1, flash %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paused by STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>resumed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ended: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1, %2: paused by STOP while %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re-arm and resume, or cancel it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1, %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, about %2 left.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading its parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>marking it as without data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looking at what is there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>erasing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>writing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>verifying</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>committing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rebooting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading its signatures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing in it has changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It says that its flash has no data: it runs, and cannot drive before the next upload, which goes on where this one ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it has in its flash was verified; it takes effect at its next reboot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was told to reboot with what was verified, and has not said that it runs it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It runs what was sent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 has its new firmware, verified and running, after %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The upload to robot %1 was cancelled. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The upload to robot %1 failed: %2 %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>upload begun, pages to send: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>upload paused by STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>upload resumed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>upload done after %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>upload ended: %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameters before it began: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Image</name>
    <message>
        <source>the last address of the flash is %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the last address of the microcontroller is %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is data at address %1;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1 has data for address %2;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has %1 bytes; no firmware file has more than %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no data in the file that the robot would take.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1 is no Intel HEX record: character %2 does not belong there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The bitstream has %1 bytes where its header promises %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1 has %2 hex digits where %3 belong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1 is damaged: its checksum is %2, and its bytes give %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1 has record type %2, which Intel HEX does not have.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line %1 has data for address %2, which has some already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has been cut off: its end record is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Something follows the end record, in line %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of the .bit file cannot be read from byte %1 on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is firmware for the microcontroller, not a bitstream: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a bitstream for the FPGA, not firmware: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file cannot be used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the other target, or the right file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that it is the right file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Build the file again, or fetch it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FPGA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>microcontroller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intel HEX</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>binary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Xilinx .bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has the header of a Xilinx .bit file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it begins with the word by which an FPGA finds its bitstream</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it begins with the jump that starts a microcontroller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is larger than the microcontroller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>going by the format alone</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>KickState</name>
    <message>
        <source>The high voltage of %1 is not armed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A sweep of robot %1 is running.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A kick is for one robot: choose one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything is stopped. Re-arm first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link does not run: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The emergency stop is not in run (%1). Turn it to run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a robot: click its tile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not heard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width 1 is 0: no pulse.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width 2 is 0: no pulse.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both widths are 0: a robot takes that as disarmed.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>KickWords</name>
    <message>
        <source>%1 → %2 (%3 V)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measuring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 / %2 µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, solenoid 2 later by %1 µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, solenoid 1 later by %1 µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>t1 %1 · t2 %2 · Δt %3 · flags %4 %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no drop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kicked again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measuring…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, charging again…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, charged again in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the capacitor stayed at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the readings are missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another kick came too soon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, recharge not measured: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not measured: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>autokick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done: %1 kicks given to the dongle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ended after %1 of %2 kicks. %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kick %1 of %2 · %3 · %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charging for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not charged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · took %2 from switching on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recharging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charger off, still live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not full again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, not full again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped after %1 of %2 kicks.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Leds</name>
    <message>
        <source>front left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>back left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>back right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>front right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dribbler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal lights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All four on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hall sensors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Encoder lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Encoder count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>class %1, which is not defined</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hall sensor A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hall sensor B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hall sensor C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Encoder line A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Encoder line B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bit 0 of the count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bit 1 of the count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bit 2 of the count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bit 3 of the count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pulse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each charge pulse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charge time-out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot uses its lights for what its firmware wants.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All four should be lit: one that is dark is broken.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the dribbler by hand: one light after the other changes. All three dark or all three lit is a fault.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the wheel by hand: one light after the other changes. All three dark or all three lit is a fault.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the wheel by hand: the two lines should alternate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the wheel by hand: the low four bits count, LED 0 fastest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the charger on: LED 0 flickers until the capacitor is full. LED 1 lit: charging took too long.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LiveWarning</name>
    <message>
        <source>Everything has been braked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before anybody touches a robot: stay, re-arm, arm its high voltage and choose Discharge in the Drive panel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A robot that is not heard cannot be discharged from here: switch it on again and bring it near, or treat it as live and measure before touching it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A robot that starts a plan when its connection ends moves as soon as you leave: keep clear of it, or switch it off first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A robot out of reach cannot be stopped from here: keep clear of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 s ago: keep clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 s ago: treat as live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Live capacitors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robots that move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Capacitors are still charged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A robot will move, or does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stay</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MarkText</name>
    <message>
        <source>trigger</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MotionplanView</name>
    <message>
        <source>Motion plans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NXT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A simulated NXT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start with a simulated NXT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A virtual robot that takes motion plans and executes them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated NXT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP cannot reach the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 telegrams out, %2 in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 sent again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 unanswered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 damaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot starts its trigger plan %1 when the connection ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a virtual NXT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bluetooth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lost messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unanswered reads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Doubled messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delay of messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lose the next to the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lose the next from the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mailbox read as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Updates at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In reach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NXT %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot may start trigger plan %1 when the connection ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lose one of the next from the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whether the robot has a trigger plan, which starts when the connection ends, is not known</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Options</name>
    <message>
        <source>A bench for small robots: drive, watch and stop them.

Example: kickstand --link sim:thunderbots?robots=0-3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect to this link at the start; may be given several times. Without it the window looks for hardware, and offers simulated robots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show every panel on simulated robots, do the main jobs, write pictures into this folder, and end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Print &quot;painted&quot; when the window has been painted: to measure the start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>system, light or dark, for this run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open another window although one is open. Two windows can drive the same robots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Try --help.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an option. A link is given with --link; try --help.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--theme takes system, light or dark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--tour drives simulated robots alone: leave --link out.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PadMap</name>
    <message>
        <source>left stick to the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left stick to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left stick up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left stick down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right stick to the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right stick to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right stick up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right stick down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left trigger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right trigger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left stick pressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right stick pressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left shoulder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right shoulder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pad up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pad down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pad left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pad right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>button %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheels 1, 2 forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheels 3, 4 forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dribbler on, off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axis %1, reversed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>not configured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Once this is committed and the robot has rebooted,</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the robot&apos;s next boot on, be it a reboot or its switch,</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When the robot comes back,</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rebooted, to come back as robot %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not read yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As read from the robot; nothing changed since.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Applied: lives until the robot reboots. Commit it to keep it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Committed, unproven until the next reboot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Committed and rebooted; reading it again will prove it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Proven: read after a reboot, and just what was committed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not kept: after the reboot the robot has something else than was committed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flash contents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channel of radio 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channel of radio 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dribbler duty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FPGA bitstream</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of its radios has no channel: no dongle hears robot %1 any more, and only its cable reaches it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it uses channels %1 and %2, and this dongle does not: robot %3 is lost to it until the dongle is set to those channels too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it answers as robot %1, and so does the robot %1 that is heard now: the two disturb each other, and both do what either is told.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot %1 answers as robot %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it copies whatever is in its flash into its microcontroller. If that is no verified firmware, the robot does not start any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its FPGA gets no bitstream, and it cannot drive.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameters read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameters applied: they live until the robot reboots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameters committed, unproven until the next reboot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameters proven: kept over the reboot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameters not kept: the robot has something else after its reboot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>build signatures: microcontroller %1, flash %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reboots, and is gone for some seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>microcontroller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its FPGA is given whatever is in the flash. If that is no verified bitstream, the robot cannot drive.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ParametersPanel</name>
    <message>
        <source>Apply this to robot %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commit this in robot %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reboot robot %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply all the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commit all the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reboot all the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect first: parameters live in the robots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one robot: each has parameters of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 is not heard: switch it on, or wait while it reboots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for robot %1, attempt %2 of %3…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for robot %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything is stopped: re-arm before a reboot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before a reboot the robot has to be braked, its charger and autokick off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before a reboot the robot&apos;s capacitor has to be known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before a reboot the capacitor has to be below 50 V, and it is at %1: discharge it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlanWords</name>
    <message>
        <source>plan %1 in slot %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>create</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>update</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>execute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>query</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>adjust</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trigger plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connected; nothing was started or stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disconnected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>link lost. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>link failed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waiting for the robot&apos;s serial port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the NXT says: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unreadable messages: %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slot %1 is empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slot %1 holds plan %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>created %1, movements: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>updated %1, movements: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trigger plan %1 set: it starts when the connection ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no trigger plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trigger plan %1, movements: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot reports error %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the robot confirmed something else: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>executing %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has come to its end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped: nothing was executing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped, as the robot confirms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop was sent, and the robot did not confirm it: it may go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 executes, and nothing is heard of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed of %1 changed by %2 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot&apos;s Bluetooth is gone: it goes on with its plan or starts its trigger plan, and STOP cannot reach it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waiting for the serial port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>opening; Bluetooth can take seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connected</source>
        <comment>link</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed</source>
        <comment>link</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>asked to execute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>executing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>may be executing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both wheels forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both wheels back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left wheel forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left wheel back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right wheel forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right wheel back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>forward %1 cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>back %1 cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn right %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn left back %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn left %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn right back %1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>something that this program has no words for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: nothing came back that confirms it; look at the robot</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlotText</name>
    <message>
        <source>A → B  Δt %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trigger %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PortOffers</name>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RemedyText</name>
    <message>
        <source>%1 copy the command.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RobotTile</name>
    <message>
        <source>braked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>holding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kept full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>autokick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dribbler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lowest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last seen %1 ago: treat as live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last seen %1 ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>battery %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the lowest of all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>capacitor %1, live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>capacitor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the only one %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>heard, no readings yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 has not been heard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery %1 V (ADC %2): low below %3 V, empty below %4 V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Capacitor %1 V (ADC %2): live from %3 V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dribbler %1 ଌ (ADC %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Break beam (ADC %1): %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>heard, readings %1 old</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cable ok · now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radio ok · now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heard, but its readings have not been valid for %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lost %1 ago: the readings are of before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heard over the cable now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heard by the dongle’s radio now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The readings last changed %1 ago.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 is heard, and has sent no readings yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The only one %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SaveFile</name>
    <message>
        <source>Not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be written: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 files (*.%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SmartDevices</name>
    <message>
        <source>%1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finding out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disabled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stale, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>busy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not permitted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>silent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody answers at %1. Check that it is a board of the kit with its firmware, and its cable; then search again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changed from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>p99 %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no updates are asked for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>asked for again when it is back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>asked for, not granted yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>granted: %1 of %2 parameters, every %3 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sent, no answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost before it answered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>asked for many times, not granted</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SmartdeviceView</name>
    <message>
        <source>Smart devices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Devices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Six simulated smart devices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start with simulated smart devices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A motor, a battery, switches, a line follower, servos and a team flag of the PiE kit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smart devices on USB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look for smart devices on USB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every serial port that is on USB is asked; opening one resets its board.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated smart devices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · looking for ports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n live</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stale</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lost</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1 messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 damaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>six virtual boards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>virtual boards: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>USB plug</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrong checksums</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused writes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pressed switches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tape under it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dial 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dial 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dial 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Joint&apos;s speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Imbalance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tag near it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor&apos;s load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Silent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 and 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 and 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 and 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Board %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At a glance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Current drawn</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>State</name>
    <message>
        <source>not stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the emergency stop left “run”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a robot was lost while it was in use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the link was lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the window lost the keyboard while something moved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the program did not respond in time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the panel that drives was closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the computer went to sleep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waiting for the device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>opening the device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>starting the radios</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>braking all robots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>running</source>
        <comment>link</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed</source>
        <comment>link</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not known yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not plugged in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not started</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radio 0 starts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radio 1 starts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>running</source>
        <comment>radios</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radio 0 failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radio 1 failed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StopWords</name>
    <message>
        <source>Robots may not have been told: they brake by themselves within 2.2 s. Look before you reach for them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The boat may not have been told: its own timer stops it a second after the last velocity that it heard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero velocity is sent in the next slot, and held until you re-arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boards may not have been told. A PolarBear disables itself when its heartbeats stop; of others nobody knows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero was written to every duty cycle and speed, and every board was disabled. Positions were left alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop is being sent to the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot has stopped, and executes a plan since: stop it again, or use its own button.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot stands, as it says itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop was sent %1 times and not confirmed: the robot may go on. Use its own button.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop is sent as soon as the robot is connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its port takes nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is silent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2 (%3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what is at %1 (another program holds the port)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no board that could be told.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These may not have been told: %1. Look before you reach for them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 To the duty cycles and speeds of all others zero was written, and they were disabled; positions were left alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A kick that the dongle already held may still have been given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every robot was told to brake; chargers, dribblers and autokick are off. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every robot that is heard was told to brake, with its charger, dribbler and autokick off. No longer heard, and perhaps not told: %1. Look before you reach for it. %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ThunderbotsView</name>
    <message>
        <source>Simulated cable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot cable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated dongle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dongle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radios running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E-stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thunderbots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voltages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kicks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Test LEDs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiment data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gamepad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fault codes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sixteen simulated robots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start with sixteen simulated robots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A virtual dongle and its robots: nothing to plug in, nothing to break.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same sixteen, heard through a bad radio.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One simulated robot on a cable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One virtual robot, connected without a radio.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 packets/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radios %1 / %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>server %1 ms away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 damaged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 stalls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot %1: %2 on its capacitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>virtual robot %1 on a cable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sixteen virtual robots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>virtual robots %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; radio loss %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Capacitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dead wheels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radio failure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radio loss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicated packets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radio delay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>USB plug</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stalled endpoint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dongle error code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Broken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Works</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unplugged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radio 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radio 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0x05 drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0x85 feedback</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0x06 messages out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0x86 messages in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0x81 status</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0x82 errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0x84 debug text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sixteen robots, 5 % radio loss, simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sixteen simulated, 5 % radio loss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Wheel speeds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the emergency stop back to run first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TileMarks</name>
    <message>
        <source>armed for autokick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not armed for autokick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not charging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>braked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dribbling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not dribbling</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>TimeText</name>
    <message>
        <source>now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Voltages</name>
    <message>
        <source>%1 %2 · %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at its end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>locks itself out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dribbler switches itself off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kick %1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: kick given to the dongle, its longer pulse %2 µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>autokick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 kicked by itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fault %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dongle error %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>re-armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re-armed after STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>link lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link was lost or closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not heard any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Capacitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dribbler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Break beam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ADC</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot %1 heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot %1 lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n kicks</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n autokicks</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n faults</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n STOPs</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>re-armed %n times</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>connected %n times</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>link lost %n times</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n robots heard</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>robot %1 heard %n times</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n robots lost</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>robot %1 lost %n times</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>robot %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>WheelText</name>
    <message>
        <source>rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rpm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 turns/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rad/s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>%1 is too much for %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no %1 here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no option %1 here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 takes no value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave out the “=”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 needs a value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write it as %1 %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was given twice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give it once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” has another form.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is: kickstand-sim ctl %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bytes written to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was asked for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kickstand-sim ctl actions lists what there is to do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not everything could be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check where the output goes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No simulator answers at %1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start one, as kickstand-sim thunderbots --usbip, or name its control socket with --control PATH.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” means nothing in this request.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It takes: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name another place with --control PATH.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder %1 cannot be made: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder %1 is not this user&apos;s alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another simulator has its control socket at %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End that one, or name another place with --control PATH.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There can be no control socket at %1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--control names no place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the path of a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Port %1 of %2 is in use.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another with --port N, or --port 0 for any that is free.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This user may not listen on port %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one from 1024 on, with --port N.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not an address of this machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not an address that only this machine reaches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is a numeric one, as 127.0.0.1 or ::1; one that other machines reach needs --any-address, and whoever reaches it can use the device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing can be served at %1, port %2: %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another with --address and --port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all robots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robots %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>brake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dribbler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>autokick</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand-sim</name>
    <message>
        <source>Numbers from 0 to 15, as in 0,3,5-7.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One of: true, ideal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A share from 0 to 1, as in 0.05.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A whole number from 0 on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot&apos;s number, 0 to 15.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::app::Tour</name>
    <message>
        <source>did not come about in time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot write to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cannot write %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::BodyBox</name>
    <message>
        <source>x forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>m/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counter-clockwise, seen from above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheels: each robot its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheels  %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>   slowed to %1 %: ±%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No wheel may be faster than ±%1: the motion keeps its direction and is slowed down to x %2, y %3 m/s, rotation %4 rad/s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheels 1 to 4: what the motion makes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::CapacitorReadout</name>
    <message>
        <source>no capacitor is known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot %1&apos;s capacitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>highest of those chosen: robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · %1 ago: treat as live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Capacitor %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::CardsPanel</name>
    <message>
        <source>No board is there yet. Each one gets a card here as it is found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows all its parameters</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::ChartView</name>
    <message>
        <source>State chart</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::ChecksPanel</name>
    <message>
        <source>Arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;kip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps of the check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves or prints the report.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no robot chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charge and kick need the robots armed: press Arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arms the high voltage of the chosen robots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checks the chosen robots on their stands, one after another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::ChecksRows</name>
    <message>
        <source>Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::ChecksSettingsBox</name>
    <message>
        <source>Wheels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dribbler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charge and kick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Test LEDs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads limits from a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves these limits as a file; the command line takes it too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usual</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the limits that the program came with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load limits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limits (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, units (%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::CoachPanel</name>
    <message>
        <source>Team of this COACH</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Team color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Boats that are heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TOWRP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strength</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unlock jettison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jettison the crew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suppress mutiny</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Actions that quell a mutiny, in their order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One to eight names with commas between them; Enter takes them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free digital</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free analog, in percent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free analog</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No radio module of a COACH is connected. Connect a serial port with an XBee adapter, or simulated boats.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. The Radio panel looks for the module and sets it up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paired with this COACH</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>obeys COACH %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>available</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 dBm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The helm works once a boat is paired.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Told: %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>answered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not answered yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crew obeys.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MUTINY: suppressing, %1 s left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MUTINY: %1 s left, actions done: %2 of %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COACH %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COACH </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Red team</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blue team</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lost line or closed window: the boat&apos;s own timer stops it, 1 s after its last velocity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gamepad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. A boat that was driven stops by its own timer, within a second of its last velocity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crew has taken the boat.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The boat does not answer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steers with the sticks for forward and turning. From then on its STOP button counts, whether it steers or not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not heard any more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not listened to while paired</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::Connector</name>
    <message>
        <source>Enter link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A link, such as usb:?port=1-2.3 or sim:thunderbots?robots=0-3&amp;loss=0.02</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>USB device %1:%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · USB %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> — cannot be opened: why?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No hardware found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter &amp;link…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial ports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hardware to look for</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::ConversationView</name>
    <message>
        <source>Conversation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Packets will show here as they are sent and heard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  from %2  %3  (%4 dBm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  to %2  %3  (%4)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::CurveTableModel</name>
    <message>
        <source>Not heard any more: treat as live.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not heard any more: the last value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the cursors, and from the first to the second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the visible span; the mean is weighted by time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Δ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Max</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::DeviceCard</name>
    <message>
        <source>%1, %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::DeviceList</name>
    <message>
        <source>Boards and ports</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::DevicePanel</name>
    <message>
        <source>No board is there yet. Each one is shown here as it is found.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read all once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is written until you re-arm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the board</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What you call it; kept with its UID, wherever it is plugged in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board stops everything. The next value that is written lets it go on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time between two updates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How often the board is asked to send the checked parameters; 0 for never. The board may grant another time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>never</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Updates every</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asks for every parameter that can be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2 · UID %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · answers in %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::DevicesPanel</name>
    <message>
        <source>Search again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tries every port again at which no board answered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is lost: check its cable and power. It is found again by itself, and nothing is written to it then.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for serial ports.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no serial port on USB. Plug a board in: it is found by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n live</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>kickstand::ui::DoctorRow</name>
    <message>
        <source>Copy command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the command for: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::DoctorWindow</name>
    <message>
        <source>Why does it not work?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was looked at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All lines as text, to send to somebody who can help.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing that was looked at is wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin here: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is broken. To look at: %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::DriveControl</name>
    <message>
        <source>Not connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything is stopped. Re-arm to drive again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link does not run: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The emergency stop is not in run (%1). Turn it to run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a robot: click its tile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not heard: %1. Switch it on, or choose another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The dongle or cable is not there. Plug it in.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::DriveKeysBox</name>
    <message>
        <source>Forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive by keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While this is on, the letters beside it drive for as long as they are held.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast keys drive, in percent of the limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The key is not repeated any more: zero. Press it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This letter is taken: it sets the wheels to zero. Press another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: key %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press the letter that is to do this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2. Click to choose another letter.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::DrivePad</name>
    <message>
        <source>The gamepad is gone: the chosen robots were told to brake. Plug it in or wake it up, and let its sticks go.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Something else is held that drives. Let go of it, and of the sticks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A kick is for one robot: choose one that is heard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pulse that is set in the Kick panel does not exist on the wire.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That is the STOP button. Choose another, or give STOP another button first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing has moved on the gamepad for 5 s: the chosen robots were told to brake. Wake it up, and let its sticks go.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::DrivePadPanel</name>
    <message>
        <source>Gamepad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive with it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its STOP button counts in any case.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Body</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sticks move the body: forward, to the left, turning.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One stick for the wheels of each side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dead zone in percent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bend of the curve in percent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of a stick at its end, in percent of the limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dead zone, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full stick, % of limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no robot chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No gamepad is plugged in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move a stick…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>press a button…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click, then move the stick this way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click, then press the button.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug a gamepad in. It is found at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is driven while an input is being chosen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does not drive. Its STOP button counts all the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It drives what is chosen. Letting the sticks go stops.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let go of both sticks: then they count.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::DrivePanel</name>
    <message>
        <source>Something else is held that drives. Let go of it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no robot chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>told: —</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>told: each something else</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>told: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::EventModel</name>
    <message>
        <source>%1 (%2 times)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
Double-click or Enter says more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What happened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::EventsPanel</name>
    <message>
        <source>explain ›</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Events, newest first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Explain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save all that is shown…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show events that contain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show events from this weight on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dangers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the newest in view. Scrolling down lets go of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies the lines that are marked, or all that are shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes all that is shown to a CSV file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n event(s) came too fast to be kept</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>the oldest %1 gave way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save events</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing has happened yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing that happened passes the filter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show events of the source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All sources</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::ExperimentBytes</name>
    <message>
        <source>Offset %1: not arrived</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::ExperimentPanel</name>
    <message>
        <source>Experiment buffer, hexadecimal, sixteen bytes a row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whose experiment data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies offsets and values, as they would be saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forgets this robot&apos;s bytes, so that the next experiment begins empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing has arrived from robot %1. A robot sends its buffer by itself when its experiment has ended; nothing here starts one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages refused, because their offset was past 224: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 · %2 bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save experiment data</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::ExperimentPlot</name>
    <message>
        <source>Bytes over offset: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::FaultsModel</name>
    <message>
        <source>Motor 5, dribbler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radio %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dongle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seen in this run</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::FaultsPanel</name>
    <message>
        <source>Fault codes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search: 41, radio 1, encoder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the fault codes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both tables</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dongle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No pipe carries these yet: they serve for looking up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>codes in no table: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::FlashFilesPage</name>
    <message>
        <source>Which firmware? One file, or one for each chip. Drop them here, or choose them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose files…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No file yet. Intel HEX, raw binary and Xilinx .bit are read, up to 8 MiB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the FPGA&apos;s file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which chip file %1 is for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Microcontroller</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FPGA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose firmware</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firmware (*.hex *.ihx *.mcs *.bin *.bit)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>guessed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chosen by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>can be sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>refused</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::FlashPanel</name>
    <message>
        <source>Next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start upload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New upload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no robot chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · paused by STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not taken: one file for each chip is all there can be. Remove one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save log</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::FlashProgressPage</name>
    <message>
        <source>Cancel all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends all uploads at once. What has been written is used by the next one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel the upload to robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 done. Leave the robots switched on and where they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paused by STOP: nothing more is written. Re-arm, then resume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paused by STOP: nothing more is written. Resume, or cancel.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::FlashResultPage</name>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not begun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save all logs…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upload again to those that failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes back to the first page with these robots ticked, and the same files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save log…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the log of robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All %1 robots are done.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 robots done.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::FlashReviewPage</name>
    <message>
        <source>Read again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1: do not send what is there already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing will be sent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To %1: about %2, longer where the radio is weak.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::FlashRobotsPage</name>
    <message>
        <source>battery too low: advised against</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>capacitor not measured: treat as live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ready; it measures nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ready</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which robots? On their stands, with good batteries, and near the dongle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All that are heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Capacitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upload all the same to robots whose battery is below 14 V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A battery that gives out during an upload leaves its robot without data in its flash.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>I have seen to it that the capacitors which nobody measures are empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not connected: choose something from Connect.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot is heard yet. Switch one on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>—</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 live</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::FlashStepStrip</name>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::HelmGamepad</name>
    <message>
        <source>The gamepad is gone: zero was asked for. Plug it in or wake it up, and let its sticks go.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug a gamepad in. It is found at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the sticks go once: then they count.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The gamepad steers. Letting the sticks go stops.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::HelmPad</name>
    <message>
        <source>Helm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pull, or hold the arrow keys (with Shift gently); let go to stop. Left is counterclockwise</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::HelpWindow</name>
    <message>
        <source>Kickstand help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Contents</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::HighVoltageBox</name>
    <message>
        <source>Arm high voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charging, kicking and discharging need this. Disarming switches the charger and autokick off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charges the kicker&apos;s capacitor to 219 V.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discharge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Empties the capacitor with pulses of 96 µs until 25 V. Take the ball away first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>High voltage armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm high voltage (some are)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Discharging…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To charge, kick or discharge, arm the high voltage first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::KickFields</name>
    <message>
        <source>Width 1, µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width 2, µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solenoid 2 later by, µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Negative: solenoid 1 is later. Goes to the nearest step of 32 µs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes to the nearest step of 32 µs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 → %2 µs</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::KickLogPanel</name>
    <message>
        <source>No kick yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kicks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies the selected kicks, or all, as comma-separated values.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save kicks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 kick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 kicks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 kicks in %2 steps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Width %1 stays %2 µs, the offset %3 µs.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::KickPanel</name>
    <message>
        <source>Rename…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no robot chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on the wire: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no such kick exists on the wire</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gives the dongle one kick of %1: %2. F2 renames the button.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm autokick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Autokick armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Autokick (some)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kicks with what is drawn whenever the ball is in the beam.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last autokick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last kick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no kick yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the button says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>−%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by the last autokick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by the last kick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 fired, the last at %2, %3 ago</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
armed with %1, not with what is drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, by robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>   offset unused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both on the wire: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::KickPresetBox</name>
    <message>
        <source>Preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save, rename or delete a preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a preset “%1” already: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::KickPulsesView</name>
    <message>
        <source>Pulses of both solenoids</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>solenoid 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>solenoid 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, begins at %2 µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, ends at %2 µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Pull it, or use the arrow keys (32 µs) and Page keys (320 µs).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · solenoid 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · solenoid 2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::KickRows</name>
    <message>
        <source>%1 V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much later solenoid 2 began; negative: solenoid 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the kick until charged again, or back at 98 % of before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kicked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recharge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::KickSettings</name>
    <message>
        <source>Kick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::KickSweepBox</name>
    <message>
        <source>Start sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The other width and the offset stay as they are in the Kick panel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kicks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From, µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To, µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step, µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least so long from kick to kick. A kick always waits for a charged capacitor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kicks with each width.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::LedLights</name>
    <message>
        <source>LED %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LED %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not used in this mode</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::LedsPanel</name>
    <message>
        <source>Message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive block</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal lights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the LEDs show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of which wheel or motor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sent once, as a message: shown until another message or a reboot, also after STOP.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part of every drive block: shown while that is sent, in place of the message&apos;s; ends with STOP.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends every test mode of the chosen robots, whichever way it was asked for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link does not run: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a robot: click its tile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not heard. Switch it on, or choose another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no robot chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped: drive blocks only brake. Re-arm, or send a message.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>… and others show something else.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>● %1, shown now: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>○ %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, for %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none on this connection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the drive block</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::LimitRow</name>
    <message>
        <source>Raise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Highest wheel speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Past ᄀ there is no ramp: the robot may leave its stand. It holds until the link is closed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No ramp past ᄀ.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limit ±%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>back to ᄀ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>raise…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::MainWindow</name>
    <message>
        <source>Kickstand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re-arm   Ctrl+Shift+R</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re-arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lets robots be driven again. Nothing starts by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>these robots are simulated; HARDWARE IS CONNECTED beside them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, no hardware is connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LEFT LIVE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOPPED — %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave them live and quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are safe now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LEFT MOVING OR LIVE</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::MoraleView</name>
    <message>
        <source>Morale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Morale of the crew, and its last minute; at −10 the crew mutinies</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::PadPicture</name>
    <message>
        <source>The sticks&apos; curve, and where they stand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Across: where a stick stands. Up: what it comes to. The grey band is the dead zone.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::ParameterEditor</name>
    <message>
        <source>Off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pull to set. Double-click for zero. An arrow key changes it by one step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a number and press Enter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes in hexadecimal. Enter sends them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A number of type %1. Enter sends it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::ParameterRow</name>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, up to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
STOP writes zero to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is sent by itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the board sends %1 again and again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>set to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pending</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::ParametersField</name>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::ParametersGrid</name>
    <message>
        <source>Differs from the robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether this change is applied.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take %1 over from the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes this value over into the draft.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Differs from the draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>← all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the third column over into the draft, but for the flash contents.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::ParametersHistory</name>
    <message>
        <source>not read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
bytes %2
microcontroller %3, flash %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Earlier readings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows this reading beside the draft.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which robot it was, what was tried: a number alone is nobody&apos;s identity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings cannot be kept: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 could not be kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in the file cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every reading is kept here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No reading of robot %1 yet: every one is kept here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firmware, flash</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes this reading over into the draft, but for the flash contents.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::ParametersPanel</name>
    <message>
        <source>Open parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JSON files (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That reading is no block of parameters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to remember of this reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows a file of parameters beside the draft.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save draft…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the draft to a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the last step back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the step again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to what the robot has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads what the robot works with now, and which firmware it has.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gives the robot the ticked changes. They live until it reboots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Has the robot keep what it works with now, over reboots too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reboot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reboots the robot and reads it again, which proves a commit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no robot chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot&apos;s parameters are shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its build signatures have not been read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Build signatures: microcontroller 0x%1, flash 0x%2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply %1 changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the robot&apos;s parameters first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was applied and not committed is lost with the reboot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Earlier readings</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::PlanDocument</name>
    <message>
        <source>add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::PlanPanel</name>
    <message>
        <source>   no code: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>   zero byte</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen step once more, after itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen step one place up; steps can be dragged too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen step one place down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Split 1000 cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward 1000 cm is a zero byte, which a robot&apos;s program may take for the end: 900 and 100 cm in its place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was undone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A plan from a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plan as text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps of the plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance between the wheels, for drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>track </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 movements, %3 of 59 bytes with header and end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No steps yet. Add one above, or open a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero bytes: %1. A robot whose program reads its mailbox as text loses what follows; Split 1000 cm avoids it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Open a plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plans (*.plan *.txt)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a plan. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot.plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before the steps Create sends 00, the plan&apos;s ID and the slot&apos;s number. Its 00 is a zero byte, and so is slot 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A robot whose program reads its mailbox as text loses what follows a zero byte.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds no movement; the plan here stays as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>   ▶ executing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan %1 executes and is not drawn: it was not sent over this connection, and the robot names plans by their ID alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan %1 executes and is not drawn: it is another one than the plan here.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::PlanPath</name>
    <message>
        <source>The way of the plan, from above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grid %1 cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▶ %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::PlanRobotPanel</name>
    <message>
        <source>Stop plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops the plan that executes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Query slots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asks what is in each slot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the plan of the editor the trigger plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asks for the trigger plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adjust</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes the speed of these wheels while the plan executes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ID under which the plan is sent to an empty slot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plan ID </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Create</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sends the plan of the editor to slot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Execute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Executes the plan of slot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheels whose speed is changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both wheels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change of their speed, in percent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect to an NXT, or to a simulated one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No program is running on the NXT: start the robot&apos;s program on it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot does not answer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out of reach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan %1, step %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; nothing heard for a while</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>asking the robot, %n more waiting</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>When the connection ends, the robot starts its trigger plan; STOP cannot reach it then.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP needs Bluetooth: without it the robot goes on with its plan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not asked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plan %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>
%n step(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trigger plan: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>: %1; zero bytes, counted from 0: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plan %1, not confirmed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>
steps not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was not sent over this connection, and the robot names plans by their ID alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plan %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP needs Bluetooth: without it the robot goes on with its plan or starts its trigger plan, and STOP cannot reach it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It may be executing: nothing that confirms it came back. Look at the robot, and press Stop plan to be sure.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::PlanStepRow</name>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which way the robot moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn left back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn right back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far, in centimetres or degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, one byte</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No code for this; added as exactly the same: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No code for this, and no sum is the same. Nearest: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No plan is long enough for this: at most %1 movements fit.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::PlotChoice</name>
    <message>
        <source>on or off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters that are plotted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::PlotTools</name>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stands still; recording goes on (P)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes along with the present (F, or double-click)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two cursors and what lies between them (C; Shift+arrows move one, X takes the other)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the &amp;oldest	Home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fit what is seen	V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Usual range	U</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Span of time that is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel, + and − zoom time; with Ctrl they zoom values</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::PlotsPanel</name>
    <message>
        <source>Curves of the boards&apos; parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrow keys move, plus and minus zoom, Ctrl with them zooms values; P pauses, F follows, C shows cursors, Shift with arrows moves one, X takes the other; M goes to the next mark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>boards.png</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Values as CSV…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>boards.csv</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is seen, as a picture or as numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>re-armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re-armed after STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 reported error %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No board is there yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the parameters at the left that are to be plotted.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::RadioPanel</name>
    <message>
        <source>Find the module</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>COACH of team</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TOWRP of team</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thunderbots dongle, radio 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thunderbots dongle, radio 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thunderbots robot, radio 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thunderbots robot, radio 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Team or robot of the preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Network (PAN)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Baud</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Node name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed, not applied</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No serial port with an XBee adapter is connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Working, now at %1 baud</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Find it: at every usual speed and in every mode.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2, serial number %3, firmware %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>changed; the module has %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radio module found, not in API mode yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::RobotsPanel</name>
    <message>
        <source>%1 heard · %2 chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Driving applies to all that are chosen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 is the only one %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No link yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot is heard yet. Switch one on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to choose, Ctrl-click to add, Ctrl+A for all.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No link: last values before it was lost.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::SetPointSlider</name>
    <message>
        <source>%1, slider</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pull to drive. Double-click for zero. An arrow key changes it by one; held down, it pulls the slider.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a number and press Enter. Double-click the slider for zero.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::SimActionControl</name>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do it: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::SimMenu</name>
    <message>
        <source>Si&amp;mulate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do something to the simulated robots: a ball, a battery, a pulled plug.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2), %3 to %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Those that are chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one first</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::SimPanel</name>
    <message>
        <source>There is nothing to do by hand where robots are real.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from outside the wire</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose at the left whom to do something to: each gets a row here.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::StartPage</name>
    <message>
        <source>Why does it not work?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looks at everything between this program and a robot, and says what to do.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter link…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A robot link is plugged in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot is connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connecting brakes all robots first. Nothing moves until you drive it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug in the dongle, or a robot&apos;s own cable: it shows up here by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for a dongle or a robot&apos;s cable…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect to %1 as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A serial port does not say what is at its other end: choose it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::StatusStrip</name>
    <message>
        <source>F1 help · Space STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why does it not work?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no link</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::StopButton</name>
    <message>
        <source>Brakes every robot, and switches charger, dribbler and autokick off. Space or Esc, anywhere.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped. Stop again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::SuspendWatch</name>
    <message>
        <source>Robots are braked first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::TimePlot</name>
    <message>
        <source>Curves over time</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::TopBar</name>
    <message>
        <source>&amp;Connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connecting…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::TowrpPanel</name>
    <message>
        <source>Wake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set morale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mutiny</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Team of this TOWRP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crew&apos;s morale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets the morale to −10</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No radio module of a TOWRP is connected. Connect a serial port with an XBee adapter, or be a simulated boat.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. The Radio panel looks for the module and sets it up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not paired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>obeys COACH %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped by itself: no velocity for a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>free digital, times: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>free analog: %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>foreign packets: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Morale %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TOWRP %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TOWRP </source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::VoltagesPanel</name>
    <message>
        <source>Arrow keys move, plus and minus zoom, Ctrl with them zooms values; P pauses, F follows, C shows cursors, Shift with arrows moves one, X takes the other; M goes to the next mark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trigger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stands still when a curve crosses a level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Those that are &amp;chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robots that are shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the robots that are chosen in the grid, or some that are pinned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is shown of each robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Values as CSV…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture is in the clipboard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy &amp;table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The table is in the clipboard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is seen, as a picture or as numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No signal is chosen: choose some under Signals.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot is pinned: choose some under the first button.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot is heard yet. Curves begin with its first readings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pinned: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waiting…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>voltages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot write %1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fired at %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::VoltagesTable</name>
    <message>
        <source>Curves and their values</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::VoltagesTrigger</name>
    <message>
        <source>Wait</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve to wait for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which way it crosses the level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rises to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>falls to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stands still with the next crossing in the middle. Recording goes on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freeze when</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::WheelsBox</name>
    <message>
        <source>Wheels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Body</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release to zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dribbler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero   Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 front L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2 back L</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3 back R</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>4 front R</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One set point for each wheel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the body moves: forward, to the left, turning.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors follow the set points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motors are shorted: the wheels hold still.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A slider springs back to zero when it is let go. Numbers that are typed stay.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All four set points to zero (Z)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dribbler (some)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>differ</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::WindowMenus</name>
    <message>
        <source>Go to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Safety</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop when the window loses the &amp;keyboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While something moves. Switch it off to drive by gamepad with another window in front.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help for this &amp;panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Bench guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Contents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Why does it not work?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Kickstand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Kickstand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Kickstand %1&lt;/b&gt;&lt;p&gt;A bench for small robots: drive them, watch them, stop them.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later. It comes with no warranty.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Units</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand::ui::Workbench</name>
    <message>
        <source>Events</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstand_sim</name>
    <message>
        <source>Nothing was named that could be simulated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is: %1. kickstand-sim --help says more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Options follow the name: kickstand-sim --help shows how.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kickstand-sim %1 --help shows how it is used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the simulator&apos;s control socket, where it is not the usual one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one JSON value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>actions | show [ROBOT] | ACTION [ROBOT|all] [VALUE] | flash ROBOT FILE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tells a running simulator what to do, and shows what its robots received.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put a ball into robot 3&apos;s beam: ball 3 1. Drain a battery: battery 3 14.2. Switch a robot off
and on: kill 3, revive 3. And: e-stop stop, radio-failure 0, loss 0.1, stall 0x85, unplug,
replug. “actions” lists them all, with their bounds; “flash” saves a robot&apos;s flash memory.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing says how the device is to be served.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add --usbip: over USB/IP.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>serve it over USB/IP, under the bus id 1-1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP port; 3240 without it, 0 for any that is free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where to listen; 127.0.0.1 without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>let --address be one that other machines reach: whoever reaches it can use the device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which robots there are, as in 0,3,5-7; all sixteen without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the pace of the real radio, or none; true without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which part of the radio packets is lost, 0 to 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of all that happens by chance: the same seed, the same chances</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no dongle, but this robot on its cable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the control socket; $XDG_RUNTIME_DIR/kickstand-sim.sock without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what is said as JSON, a value a line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serves the simulated Thunderbots dongle, or one robot on a cable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It says how to reach it, and goes on until Ctrl+C, SIGTERM or SIGHUP.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See what the simulator says.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulator was not reached.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulator does not answer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulator hung up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What answers there is no simulator of this program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A request looks like {&quot;request&quot;: &quot;show&quot;, &quot;robot&quot;: 3}, in one line of at most %1 bytes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is an array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That line is not a JSON object: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” cannot be that.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is a whole number from %1 to %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That line is longer than a request can be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no such request.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“request” is one of: actions, perform, show, flash.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” takes no value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave it out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no action “%1” here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not about one %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the number out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no flash memory here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask for something else.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no %1 %2 here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number of the %1 is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is a number from %1 to %2 (%3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, or one of: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” needs a value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” cannot be “%2”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the same as %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; or %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>action</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2: </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>every %1: </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 / %2 µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>never told</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>brake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dribble</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>autokick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>timed out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plugged in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unplugged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, in use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cabled robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dongle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>e-stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radios</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>loss %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robots heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dribbler duty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flash holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after a reboot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;kick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;pulses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;capacitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>capacitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dribbler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>told last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blocks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 changes, %2 time-outs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheels turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>test mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;blocks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;kicks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;last kick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” has another form.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is: kickstand-sim ctl %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no “%1” here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Example: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kickstand-sim: simulated robots, served to any program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usage: kickstand-sim NAME [OPTION …]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this; after a name, help on that</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which version this is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exit: 0 done, or told to end; 1 it failed or was refused; 2 bad usage.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usage: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Options:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lines left out: nobody read them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serving %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Control socket: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+C ends it. Who comes and goes:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thunderbots robot %1 on a cable, simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a Thunderbots dongle and robots %1, simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a program, without the kernel:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As a USB device of this machine (Linux; usbip is in the package “usbip”):</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From another machine: the same, with this machine&apos;s address in place of %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smart devices, simulated: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are radio modules: %1, and paths for them: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give --pty a path for each address, with commas between them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where the serial ports are to be: one for each module</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the modules&apos; addresses, as in 0xBC05,0xAF05; 0xBC05 without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the modules are as they come from the factory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the teams of the boats; 3,5,7 without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the teams of simulated COACHes; none without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how often a crew&apos;s morale falls; 5 without it, 0 for never</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serves simulated XBee modules, with TOWRPs and COACHes that they hear.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where the serial port is to be</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which part of the messages is lost, 0 to 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which part of the reads is never answered, 0 to 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which part of the robot&apos;s messages comes twice, 0 to 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by how much the robot&apos;s messages come later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how much faster than real it moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its program reads mailboxes as text: what follows a zero byte is lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serves a simulated NXT that takes motion plans.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where the serial port is to be; of several boards PATH, PATH1, PATH2, …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the boards, as in PolarBear,Encoder.hibike; one PolarBear without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from the opening of the port to the first answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serves simulated smart devices on pseudo-terminals.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an XBee adapter and no TOWRP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an XBee adapter and TOWRPs %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an NXT that takes motion plans, simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing can be served at %1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another path with --pty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From any program, at these serial ports:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From this one&apos;s other half:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program serves a serial port at %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End that one, or choose another path with --pty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing says where the serial port is to be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add --pty PATH.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>values of more bytes than this come in several messages; 40 without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>boats with a bad radio, and which part of their packets is lost, as in 7:0.3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>kickstandctl</name>
    <message>
        <source>Did you mean %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 takes no value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave out the “=”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 needs a value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write it as %1 %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was given twice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give it once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no option %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kickstandctl --help lists what there is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No command was given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kickstandctl --help lists them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 needs a command of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kickstandctl %1 --help lists them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no command %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kickstandctl %1 --help shows how it is used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 takes no %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 needs %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is too much for %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Did you mean “%1”?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This message has no fields.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is no field with its value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write it as FIELD=VALUE, as in wheel1=40.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages and their fields:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with --json: add volts, µs and names beside the raw numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes a message apart into its fields. Works offline.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spaces and colons between bytes may be there or not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts a message together from its fields. Works offline.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fields that are left out are zero.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ready</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No dongle or cabled robot is plugged in. Simulated ones: --link sim:thunderbots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lists the dongles and cabled robots that are plugged in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each with its link, and what stands in the way of using it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 with Qt %2 works.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Says why it does not work: device, permission, radios, e-stop, robots; with remedies.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: all robots were told to brake; chargers, dribblers and autokick are off.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brakes everything on every link that is plugged in, or on the one that is named.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chargers, dribblers and autokick go off too. A program that holds a dongle has its own STOP. What a dongle still holds of kicks cannot be called back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same for one dongle or cabled robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--seen does not take “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It takes yes, no, ask or skip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--only does not take “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It takes battery, wheels, dribbler, kicker and leds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name a file with limits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mend %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot %1  %2: %3  %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1: %2 [y]es, [n]o, [s]kip%3: </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, [a]gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The report says which steps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which: 3, 0,3 or 5-7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>battery, wheels, dribbler, kicker, leds, with commas; all without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limits as JSON, as the Checks panel saves them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes, no or skip to all that a person has to see; ask without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>saves the report; as .html, .json or text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checks robots on their stands, step by step, and reports.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs each wheel both ways and the dribbler, charges, kicks once, and discharges. What no feedback tells is asked; with --seen the robots move unasked: they must stand free. Exit 0 only when every step of every robot passed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Driving %1 with %2 for %3 s; Ctrl+C brakes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0-15; several as in 0,3,5-7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>front left, back left, back right, front right, in quarter-degrees per 5 ms (42 is 350 rpm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>allow up to ±N (at most 1023) and no ramp above ±100; without it ±100</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run the dribbler too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs the wheels of one or several robots for a time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robots brake when the time is over, and when the command ends in any other way.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kick for robot %1 given to the dongle: %2; its capacitor had %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 kicks by itself with %2 when it has the ball, for %3 s; Ctrl+C disarms.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 did not come to %2 in time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give it longer with --for, and check its battery.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0-15</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end as soon as the capacitor has so many volts; exit 1 when it does not get there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keep the capacitor charged meanwhile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kicks once. Arms the high voltage of that robot itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Times go to the nearest 32 µs; what is really sent is said. A kick is given to the dongle: no robot says that it kicked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lets a robot kick by itself whenever it has the ball, for a time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charges a robot&apos;s capacitor for a time, or up to a voltage.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The charge stays when the command has ended: treat the robot as live until it was discharged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Empties a robot&apos;s capacitor with short pulses, down to 25 V.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pulses are too short to move the ball far, but keep clear of the kicker.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If that is meant, give --yes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>microcontroller %1, flash %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 has rebooted and is heard as robot %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No value was given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give FIELD=VALUE, or --file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>do it although it may lose the robot, or what was not committed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a JSON file of parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reboot the robot and read them again, which proves the commit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads the operational parameters of a robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are those that it works with now; only after a reboot they are those that it keeps. --file writes them down too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes parameters of a robot, until it reboots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fields: flash_contents, channel0, channel1, robot_number, dribbler_duty. What is given stands over what --file has. Numbers and channels count from the boot after a commit on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Has a robot keep its parameters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values that are given are set before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads which firmware a robot has, as two CRCs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It takes the robot some seconds to compute them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reboots a robot and waits until it is heard again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has to be at rest and discharged. What was applied and not committed is lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--class cannot be that.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is one of: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Class %1 has no targets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave --target out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Class %1 needs --target.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is a number from %1 to %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Test mode for robot %1 given to the dongle: %2 %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Test mode for robot %1 given to the dongle: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The channel of radio 1 is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give both, as in 0x0E 0x0F, or none to read them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radio 0: channel %1 (0x%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radio 1: channel %1 (0x%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none, lamp, hall, encoder, encoder-count or charger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hall: motor 1-5, 5 the dribbler; encoder, encoder-count: wheel 1-4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chooses what the four LEDs of a robot show.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They show it until they are told otherwise, or the robot reboots. “none” is normal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads the dongle&apos;s two radio channels, or sets them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each 0x0B-0x1A, or 11-26. Setting them brakes all robots and starts the radios anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>capacitor %1 to %2, a drop of %3 V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, charged again in %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 / %2 µs: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the first width, in µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the last width, or the last before it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from width to width; at least 32</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>whose width: 1 (the kicker) or 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the other solenoid&apos;s pulse; 0 without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how much later solenoid 2 begins, in µs; negative: solenoid 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kicks with each width; 1 without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at least so long from kick to kick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long charging may take before it ends with exit 1; 30 without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kicks with one width after another and measures what each does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arms the high voltage of that robot itself, keeps its capacitor charging, and waits for it before each kick. Ctrl+C stops it. The charge stays when the command has ended: treat the robot as live until it was discharged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no readings yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not heard for %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>battery at its end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>battery low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LIVE capacitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, channels %1 and %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>server %1 ms away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>link</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>e-stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radios</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;capacitor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;dribbler</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not heard: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long; without it until Ctrl+C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the link, the e-stop, the radios and every robot, once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Prints events, and readings as they change.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one JSON value; a value a line where it streams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this; after a command, help on that command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which version this is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kickstandctl: drive, tune and watch small robots from the command line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usage: kickstandctl [--link URI] [--json] COMMAND …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For all of them:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Example: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whatever ends a command, a signal too, leaves the robots braked. Exit: 0 done, 1 the robot or link refused or failed, 2 bad usage.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usage: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Options:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For all commands:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 / %2 µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, solenoid 2 later by %1 µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, solenoid 1 later by %1 µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (on the grid of 32 µs)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long solenoid 1 (the kicker) is on, in µs; at most 4064</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the same for solenoid 2 (the chipper); 0 without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not everything could be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check where the output goes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep clear: the robots brake by themselves within two seconds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All robots are braked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the robots are braked is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” cannot be read: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the name of the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is no FIELD=VALUE.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The fields are %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” cannot be written: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check the place and the room on it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug one in, or name a link, as in --link sim:thunderbots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name one of them with --link: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything was stopped: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put that right, then start the command again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cabled robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dongle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>simulated %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 had %2 on its capacitor: treat as live.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be “%2”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is a whole number from %1 to %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--robot cannot be “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is one robot from 0 to 15, or several, as in 0,3,5-7.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--wheels cannot be “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is four speeds with commas between them, as in 40,-36,36,0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel %1 cannot be “%2”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More than ±%1 needs --limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 has microcontroller %2, flash %3: already there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 has microcontroller %2, flash %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is to be done; --force sends it all the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This would replace the firmware of %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Afterwards the robot has no bitstream, and cannot drive before it is sent one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1 has something else than the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flash it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robots: 3, or 0,5-7</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>do it; without it nothing is changed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only read the files; needs no robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>send it to robots too that have it already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flash robots too whose battery is below 14 V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a robot that reports nothing has an empty capacitor: you have seen to it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>write down what was done, and when</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uploads firmware to robots, verifies it and reboots them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files: Intel HEX, binary, Xilinx .bit; one, or one for the microcontroller and one for the FPGA. Robots that have it already are left out. They have to be at rest and discharged. Ctrl+C cancels and says how each robot is left; the next run goes on from there. Exit 1 when any upload failed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compares a robot&apos;s firmware with files, by its signatures.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exit 0 when they are the same, 1 when not. Changes nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--target is “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give pic or fpga.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--target is about one file, and two were given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave it out: the files themselves show what they are for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both files are for the same target: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give one file for the microcontroller and one for the FPGA.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2, %3, bytes of data: %4, pages to send: %5, signature %6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, for %1, made %2 %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; left out: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;TOWRP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;strength</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;packets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 dBm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>obeys COACH %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>available</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No TOWRP is heard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  %2  %3 dBm  %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Driving: %1, for %2 s; Ctrl+C stops.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velocity: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the team of the boat; without it this COACH&apos;s own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>red (as without it) or blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>-100 to 100, snapped to the nearest of 0, 15, 29, 45, 59, 75, 89, 100</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the same; positive is counterclockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>-100 to 100</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the crew&apos;s morale once it is paired; -10 is a mutiny</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plays the COACH that the radio module is set up for: its startup first, then the boat that is asked for. When it ends in any way, zero velocity is sent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only listens: nothing is sent by radio.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lists the TOWRPs that are heard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows every packet that is heard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pairs with a boat and holds it still for a time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drives a boat for a time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sends Free Digital to a boat.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sends Free Analog to a boat.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sends Suppress Mutiny to a boat.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gives a boat up.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plays the TOWRP, the boat, for a time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So that a team can test its own COACH.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>network (PAN)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>baud</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>node name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>serial number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>firmware</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no such preset.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give coach, towrp, dongle or robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look at every speed, also where the module answers at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coach or towrp (with --team), dongle (with --radio), robot (with --robot and --radio)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0-255</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 or 1: which of a Thunderbots dongle&apos;s or robot&apos;s two</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>16 bits, as in 0xBC05</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0x0B to 0x1A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the network&apos;s number, 16 bits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 transparent, 1 API, 2 API escaped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1200 to 115200, or 250000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the node&apos;s name, at most 20 characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads the settings of the radio module.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A module that does not answer at this link&apos;s speed in API mode is looked for at every speed and in every mode, which takes up to half a minute.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets the radio module, makes that last, and reads it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is not given stays as it is. A fresh module needs no other program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No plan is given.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write it, as in &quot;forward 25, turn left 84&quot;, or name a file with --file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This link does not lead to a robot with motion plans.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name one, as in --link serial:/dev/rfcomm0?protocol=motionplan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot stands, as it says itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0-4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a file with the plan, instead of its text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1-254</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the plan in the slot; without it the one that is there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0-4; all of them without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1-254; 1 without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts a plan into an empty slot of the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A plan is text: forward 25, back 50, turn left 84, turn right back 30; centimetres and degrees, parted by commas.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaces the plan in a slot of the robot.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asks which plans are in the robot&apos;s slots.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets the plan that starts when the connection is lost, or reads it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Without a plan it only reads. A robot cannot tell a connection that was closed from one that was lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows what the robot says of itself; leaves it as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops the plan that executes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It cannot reach a robot whose Bluetooth is gone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the robot stands is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a plan that is put into the slot first, as PLAN is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long it may go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Executes the plan of a slot, and stops it when the time is over.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It ends when the plan does. With a plan, as text or in a file, that is put into the slot first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes the speed of wheels while a plan executes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is stopped when the time is over.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This link does not lead to smart devices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name serial ports, as in --link serial:/dev/ttyACM0, or sim:smartdevice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no device “%1” here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are several devices “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no parameter “%2”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no smart device here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2 answers after %3 ms (median), %4 ms (99 of 100)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is no parameter with its value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write it as NAME=VALUE, as in duty_cycle=0.2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What moves needs --for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say how long, as in --for 2: the device is stopped afterwards.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was told to stop everything.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The devices were told to stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how long; needed for what moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from one update to the next; 40 without it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lists the smart devices that are plugged in, and the ports without one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures how fast a device answers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads parameters once; all without a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes parameters, and says whether the device took them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Prints parameters as the device sends them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lets a device stop everything; its next write resumes it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See that its capacitor is empty, then give --discharged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the one file is for, where its bytes do not show it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is no team color.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give red or blue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep clear: the boat stops by itself within a second of its last velocity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No boat is driven any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the boat has stopped is not known; its own timer stops it within a second.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which serial port the radio module is at is not said.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name it: --link &apos;serial:/dev/ttyUSB0?protocol=coach&apos;, or --link sim:coach.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This link is not one to a COACH&apos;s or TOWRP&apos;s radio module.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name one, as in --link &apos;serial:/dev/ttyUSB0?protocol=coach&apos;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What “%1” is for cannot be told for certain: probably %2, %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say it with --target pic or --target fpga.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; for this target because %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>usb:, usb:?port=1-2.3, usb-cable:, usbip:127.0.0.1:3240/1-1, serial:/dev/rfcomm0?protocol=motionplan, sim:motionplan or sim:thunderbots?robots=0-15&amp;loss=0.02; without it the only hardware that is found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plan is given twice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give it as text or by --file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name a file with a plan, such as one that the window has saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--wheels is “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One of: both, left, right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not asked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trigger</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 plan %2 in slot %3, step %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening a link to thunderbots brakes them; closing one to an NXT starts its trigger plan, as ever. Exit 1 when something is wrong.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the robot stands, as it says itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: everything was told to stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closing the connection starts its trigger plan %1: it drives off now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closing the connection may start its trigger plan %1: it may drive off now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether it has a trigger plan, which closing the connection starts, is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plan %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DEVICE is its kind (PolarBear) where there is one of it, the name it was given in the window, its UID, or its port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 grants updates every %2 ms (asked: %3 ms) of %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 updates came too fast to be printed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name one by its kind, its own name, its UID or its port; there are: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name one by its own name, its UID or its port; there are: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bytes in hex, %1 of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on or off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 can only be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write to another parameter; the help page of the boards says which.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 began anew meanwhile: what was written is gone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: told to stop: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody answers at %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check that a smart device is at its end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug one in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 stopped by itself meanwhile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Check its power supply and its cable, then write it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no program is running on the NXT</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
